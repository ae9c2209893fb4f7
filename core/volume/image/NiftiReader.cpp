// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NiftiReader.h"

#include "base/ByteOrder.h"
#include "volume/image/ImageHeader.h"
#include "volume/image/Inflate.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr std::size_t kNiftiHeader = 348;  // bytes

// The header, by the offsets of nifti1.h.
class NiftiHeader {
 public:
  explicit NiftiHeader(std::string_view bytes) : m_bytes(bytes) {
    if (number<std::int32_t>(0, std::endian::big) == kNiftiHeader) m_order = std::endian::big;
  }

  std::endian order() const { return m_order; }
  int whole(std::size_t at) const { return number<std::int16_t>(at, m_order); }
  double real(std::size_t at) const { return static_cast<double>(number<float>(at, m_order)); }
  char byte(std::size_t at) const { return m_bytes[at]; }

 private:
  template <class T>
  T number(std::size_t at, std::endian order) const {
    return loadNumber<T>(m_bytes.data() + at, order);
  }

  std::string_view m_bytes;
  std::endian m_order = std::endian::little;
};

bool isNiftiHeader(std::string_view bytes) {
  if (bytes.size() < kNiftiHeader) return false;
  const bool hasSize = loadNumber<std::int32_t>(bytes.data(), std::endian::little) == kNiftiHeader ||
                       loadNumber<std::int32_t>(bytes.data(), std::endian::big) == kNiftiHeader;
  const std::string_view magic = bytes.substr(344, 4);
  return hasSize && (magic == std::string_view("n+1\0", 4) || magic == std::string_view("ni1\0", 4));
}

std::optional<SampleType> niftiType(int code) {
  switch (code) {
    case 2:
      return SampleType::UInt8;
    case 4:
      return SampleType::Int16;
    case 8:
      return SampleType::Int32;
    case 16:
      return SampleType::Float32;
    case 64:
      return SampleType::Float64;
    case 256:
      return SampleType::Int8;
    case 512:
      return SampleType::UInt16;
    case 768:
      return SampleType::UInt32;
    case 1024:
      return SampleType::Int64;
    case 1280:
      return SampleType::UInt64;
    default:
      return {};
  }
}

// mm to a unit of length; codes of xyzt_units.
double niftiUnit(char units) {
  switch (units & 7) {
    case 1:
      return 1000.0;
    case 3:
      return 1e-3;
    default:
      return 1.0;
  }
}

// Method 2 of nifti1.h: a rotation as the last three parts of a quaternion of length 1.
void setQuaternion(const NiftiHeader& header, const Vec3& spacing, ImageGrid& grid) {
  const double b = header.real(256), c = header.real(260), d = header.real(264);
  const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
  const double flip = header.real(76) < 0.0 ? -1.0 : 1.0;
  grid.steps = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix() *
               Vec3(spacing.x(), spacing.y(), flip * spacing.z()).asDiagonal();
  grid.origin = Vec3(header.real(268), header.real(272), header.real(276));
}

// Method 3: rows of the map from indices to positions.
void setRows(const NiftiHeader& header, ImageGrid& grid) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    const std::size_t at = 280 + 16 * static_cast<std::size_t>(row);
    for (Eigen::Index k = 0; k < 3; ++k) grid.steps(row, k) = header.real(at + 4 * static_cast<std::size_t>(k));
    grid.origin[row] = header.real(at + 12);
  }
}

struct NiftiImage {
  ImageGrid grid;
  SampleLayout layout;
  std::size_t offset = 0;
  std::vector<ImageRemark> remarks;
};

Result<NiftiImage> niftiImage(const NiftiHeader& header) {
  NiftiImage image;
  const int axes = header.whole(40);
  if (axes < 1 || axes > 7) return imageHeader::malformed("dim", "it is not a number of axes");
  Vec3 spacing = Vec3::Ones();
  for (std::size_t k = 0; k < 3; ++k) {
    image.grid.size[k] = static_cast<int>(k) < axes ? header.whole(42 + 2 * k) : 1;
    const double step = std::abs(header.real(80 + 4 * k));
    if (step > 0.0 && std::isfinite(step))
      spacing[static_cast<Eigen::Index>(k)] = step;
    else if (static_cast<int>(k) < axes && image.remarks.empty())
      image.remarks.push_back({ImageRemark::Kind::NoSpacing, {}});
  }
  double several = 1.0;
  for (int k = 3; k < axes; ++k) several *= std::max(1, header.whole(42 + 2 * static_cast<std::size_t>(k)));
  if (several > 1.0) image.remarks.push_back({ImageRemark::Kind::FirstOfSeveral, {several}});
  if (header.whole(254) > 0) {
    setRows(header, image.grid);
  } else if (header.whole(252) > 0) {
    setQuaternion(header, spacing, image.grid);
  } else {
    image.grid.steps = spacing.asDiagonal();
  }
  const Vec3 turn(-1, -1, 1);
  const double unit = niftiUnit(header.byte(123));
  image.grid.steps = unit * (turn.asDiagonal() * image.grid.steps);
  image.grid.origin = unit * turn.cwiseProduct(image.grid.origin);
  const auto type = niftiType(header.whole(70));
  if (!type) return Error{ErrorCode::Unsupported, {"an image of colours or complex numbers"}, {}, {}};
  image.layout.type = *type;
  image.layout.order = header.order();
  // A slope of 0 means that nothing is scaled.
  if (const double slope = header.real(112); slope != 0.0 && std::isfinite(slope)) {
    image.layout.slope = slope;
    image.layout.intercept = header.real(116);
  }
  const double offset = header.real(108);
  if (!(offset >= static_cast<double>(kNiftiHeader) && offset <= 1e8))
    return imageHeader::malformed("vox_offset", "it is not a position after the header");
  image.offset = static_cast<std::size_t>(offset);
  return image;
}

}  // namespace

bool looksLikeNifti(std::string_view bytes) {
  if (!looksLikeGzip(bytes)) return isNiftiHeader(bytes);
  const Result<std::string> head = inflated(bytes, kNiftiHeader);
  return head && isNiftiHeader(*head);
}

Result<ImageFile> readNifti(std::string_view bytes) {
  const bool isPacked = looksLikeGzip(bytes);
  const Result<std::string> unpackedHead = isPacked ? inflated(bytes, kNiftiHeader) : std::string();
  if (!unpackedHead) return unpackedHead.error();
  const std::string_view head = isPacked ? std::string_view(*unpackedHead) : bytes;
  if (!isNiftiHeader(head)) return Error{ErrorCode::HeaderMalformed, {"NIfTI-1"}, {}, {}};
  if (head.substr(344, 3) != "n+1")
    return Error{ErrorCode::Unsupported, {"an image in a pair of .hdr and .img"}, {}, {}};
  Result<NiftiImage> image = niftiImage(NiftiHeader(head));
  if (!image) return image.error();
  if (const Status checked = checkGrid(image->grid); !checked) return checked.error();
  const Result<std::string> plain =
      isPacked ? inflated(bytes, image->offset + bytesOf(image->grid, image->layout)) : std::string();
  if (!plain) return plain.error();
  const std::string_view all = isPacked ? std::string_view(*plain) : bytes;
  Result<ImageFile> read = imageOfBytes(image->grid, image->layout, all.substr(std::min(image->offset, all.size())));
  if (read) read->remarks.insert(read->remarks.begin(), image->remarks.begin(), image->remarks.end());
  return read;
}

}  // namespace handwheel
