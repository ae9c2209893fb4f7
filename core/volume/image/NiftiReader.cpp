// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NiftiReader.h"

#include "base/ByteOrder.h"
#include "volume/image/ImageHeader.h"
#include "volume/image/Inflate.h"
#include "volume/image/NiftiLabels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// The offsets of the fields in a header, as in nifti1.h or nifti2.h.
struct NiftiFields {
  std::size_t size;  // bytes of the header
  bool isWide;       // true: numbers have 64 bits, and codes 32; or else 32 and 16
  std::size_t magic, dim, type, spacing, offset, slope, intercept, units, qform, sform, quaternion, origin, rows,
      intent;
};
constexpr NiftiFields kNifti1{348, false, 344, 40, 70, 76, 108, 112, 116, 123, 252, 254, 256, 268, 280, 68};
constexpr NiftiFields kNifti2{540, true, 4, 16, 12, 104, 168, 176, 184, 500, 344, 348, 352, 376, 400, 504};
constexpr std::size_t kLargestHeader = kNifti2.size;

// A header of either version, whose first number is its size.
class NiftiHeader {
 public:
  const NiftiFields& fields;

  NiftiHeader(std::string_view bytes, const NiftiFields& of) : fields(of), m_bytes(bytes) {
    if (number<std::int32_t>(0, std::endian::big) == static_cast<std::int32_t>(of.size)) m_order = std::endian::big;
  }

  std::endian order() const { return m_order; }
  int code(std::size_t at) const {
    return fields.isWide && at != fields.type ? number<std::int32_t>(at, m_order) : number<std::int16_t>(at, m_order);
  }
  // Returns the size along an axis, from 1; the number of axes for 0. Sizes that no image can have become 0 or the
  // largest integer.
  int dim(std::size_t axis) const {
    if (!fields.isWide) return number<std::int16_t>(fields.dim + 2 * axis, m_order);
    return static_cast<int>(std::clamp<std::int64_t>(number<std::int64_t>(fields.dim + 8 * axis, m_order), 0,
                                                     std::numeric_limits<int>::max()));
  }
  // Returns the number with this index in a field.
  double real(std::size_t at, std::size_t index = 0) const {
    return fields.isWide ? number<double>(at + 8 * index, m_order)
                         : static_cast<double>(number<float>(at + 4 * index, m_order));
  }
  double offset() const {
    return fields.isWide ? static_cast<double>(number<std::int64_t>(fields.offset, m_order)) : real(fields.offset);
  }
  // Returns the units of space and time.
  int units() const { return fields.isWide ? code(fields.units) : m_bytes[fields.units]; }

 private:
  template <class T>
  T number(std::size_t at, std::endian order) const {
    return loadNumber<T>(m_bytes.data() + at, order);
  }

  std::string_view m_bytes;
  std::endian m_order = std::endian::little;
};

// Returns the version of a header; null if it is not one.
const NiftiFields* niftiVersion(std::string_view bytes) {
  for (const NiftiFields* fields : {&kNifti1, &kNifti2}) {
    if (bytes.size() < fields->size) continue;
    const auto size = static_cast<std::int32_t>(fields->size);
    const bool hasSize = loadNumber<std::int32_t>(bytes.data(), std::endian::little) == size ||
                         loadNumber<std::int32_t>(bytes.data(), std::endian::big) == size;
    const std::string_view magic = bytes.substr(fields->magic, 4);
    constexpr std::string_view kLineEnds("\r\n\032\n", 4);  // damaged by programs that convert texts
    const bool isWhole = !fields->isWide || bytes.substr(fields->magic + 4, 4) == kLineEnds;
    const char version = fields->isWide ? '2' : '1';
    if (hasSize && isWhole && magic.size() == 4 && magic[0] == 'n' && (magic[1] == '+' || magic[1] == 'i') &&
        magic[2] == version && magic[3] == '\0')
      return fields;
  }
  return nullptr;
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
double niftiUnit(int units) {
  switch (units & 7) {
    case 1:
      return 1000.0;
    case 3:
      return 1e-3;
    default:
      return 1.0;
  }
}

constexpr double kLeastSquare = 1e-7;

// Method 2 of nifti1.h: a rotation as the last three parts of a quaternion of length 1.
void setQuaternion(const NiftiHeader& header, const Vec3& spacing, ImageGrid& grid) {
  const std::size_t turn = header.fields.quaternion, origin = header.fields.origin;
  const double b = header.real(turn), c = header.real(turn, 1), d = header.real(turn, 2);
  // The rounding of a half turn's parts is no turn; nifti_quatern_to_mat44() of the reference has the same limit.
  const double square = 1.0 - b * b - c * c - d * d;
  const double a = square < kLeastSquare ? 0.0 : std::sqrt(square);
  const double flip = header.real(header.fields.spacing) < 0.0 ? -1.0 : 1.0;
  grid.steps = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix() *
               Vec3(spacing.x(), spacing.y(), flip * spacing.z()).asDiagonal();
  grid.origin = Vec3(header.real(origin), header.real(origin, 1), header.real(origin, 2));
}

// Method 3: rows of the map from indices to positions.
void setRows(const NiftiHeader& header, ImageGrid& grid) {
  for (std::size_t row = 0; row < 3; ++row) {
    const auto to = static_cast<Eigen::Index>(row);
    for (std::size_t k = 0; k < 3; ++k)
      grid.steps(to, static_cast<Eigen::Index>(k)) = header.real(header.fields.rows, 4 * row + k);
    grid.origin[to] = header.real(header.fields.rows, 4 * row + 3);
  }
}

// Returns true if the steps are linearly independent.
bool isGrid(const ImageGrid& grid) {
  const double volume = std::abs(grid.steps.determinant());
  return std::isfinite(volume) && volume > 1e-9 * grid.steps.colwise().norm().prod();
}

// Returns true if two grids are those of different images: one is mirrored, or they are meant for the same space and
// are more than a sample apart.
bool contradict(const ImageGrid& a, const ImageGrid& b, bool isSameSpace) {
  if ((a.steps.determinant() < 0.0) != (b.steps.determinant() < 0.0)) return true;
  double apart = 0.0;
  for (int corner = 0; corner < 8 && isSameSpace; ++corner) {
    Vec3 index;
    for (int k = 0; k < 3; ++k) index[k] = (corner >> k & 1) * (a.size[static_cast<std::size_t>(k)] - 1);
    apart = std::max(apart, (a.position(index) - b.position(index)).norm());
  }
  return apart > a.spacing().maxCoeff();
}

struct NiftiImage {
  ImageGrid grid;
  SampleLayout layout;
  std::size_t offset = 0;
  std::vector<ImageRemark> remarks;
};

Result<NiftiImage> niftiImage(const NiftiHeader& header) {
  NiftiImage image;
  const NiftiFields& fields = header.fields;
  const int axes = header.dim(0);
  if (axes < 1 || axes > 7) return imageHeader::malformed("dim", "it is not a number of axes");
  Vec3 spacing = Vec3::Ones();
  for (std::size_t k = 0; k < 3; ++k) {
    image.grid.size[k] = static_cast<int>(k) < axes ? header.dim(k + 1) : 1;
    const double step = std::abs(header.real(fields.spacing, k + 1));
    if (step > 0.0 && std::isfinite(step))
      spacing[static_cast<Eigen::Index>(k)] = step;
    else if (static_cast<int>(k) < axes && image.remarks.empty())
      image.remarks.push_back({ImageRemark::Kind::NoSpacing, {}});
  }
  double several = 1.0;
  for (int k = 3; k < axes; ++k) several *= std::max(1, header.dim(static_cast<std::size_t>(k) + 1));
  if (several > 1.0) image.remarks.push_back({ImageRemark::Kind::FirstOfSeveral, {several}});
  ImageGrid rows = image.grid, turned = image.grid;
  setRows(header, rows);
  setQuaternion(header, spacing, turned);
  // Some programs state a sform and leave it empty.
  const bool isTurned = header.code(fields.qform) > 0;
  const bool hasRows = header.code(fields.sform) > 0 && (isGrid(rows) || !isTurned);
  if (hasRows)
    image.grid = rows;
  else if (isTurned)
    image.grid = turned;
  else
    image.grid.steps = spacing.asDiagonal();
  if (hasRows && isTurned && isGrid(turned) &&
      contradict(rows, turned, header.code(fields.sform) == header.code(fields.qform)))
    image.remarks.push_back({ImageRemark::Kind::Contradiction, {}});
  const Vec3 turn(-1, -1, 1);
  const double unit = niftiUnit(header.units());
  image.grid.steps = unit * (turn.asDiagonal() * image.grid.steps);
  image.grid.origin = unit * turn.cwiseProduct(image.grid.origin);
  const auto type = niftiType(header.code(fields.type));
  if (!type) return Error{ErrorCode::Unsupported, {"an image of colours or complex numbers"}, {}, {}};
  image.layout.type = *type;
  image.layout.order = header.order();
  // A slope of 0 means that nothing is scaled.
  if (const double slope = header.real(fields.slope); slope != 0.0 && std::isfinite(slope)) {
    image.layout.slope = slope;
    image.layout.intercept = header.real(fields.intercept);
  }
  const double offset = header.offset();
  if (!(offset >= static_cast<double>(fields.size) && offset <= 1e8))
    return imageHeader::malformed("vox_offset", "it is not a position after the header");
  image.offset = static_cast<std::size_t>(offset);
  return image;
}

}  // namespace

bool looksLikeNifti(std::string_view bytes) {
  if (!looksLikeGzip(bytes)) return niftiVersion(bytes) != nullptr;
  const Result<std::string> head = inflated(bytes, kLargestHeader);
  return head && niftiVersion(*head) != nullptr;
}

Result<ImageFile> readNifti(std::string_view bytes) {
  const bool isPacked = looksLikeGzip(bytes);
  const Result<std::string> unpackedHead = isPacked ? inflated(bytes, kLargestHeader) : std::string();
  if (!unpackedHead) return unpackedHead.error();
  const std::string_view head = isPacked ? std::string_view(*unpackedHead) : bytes;
  const NiftiFields* const fields = niftiVersion(head);
  if (!fields) return Error{ErrorCode::HeaderMalformed, {"NIfTI"}, {}, {}};
  if (head[fields->magic + 1] != '+')
    return Error{ErrorCode::Unsupported, {"an image in a pair of .hdr and .img"}, {}, {}};
  Result<NiftiImage> image = niftiImage(NiftiHeader(head, *fields));
  if (!image) return image.error();
  if (const Status checked = checkGrid(image->grid); !checked) return checked.error();
  const Result<std::string> plain =
      isPacked ? inflated(bytes, image->offset + bytesOf(image->grid, image->layout)) : std::string();
  if (!plain) return plain.error();
  const std::string_view all = isPacked ? std::string_view(*plain) : bytes;
  Result<ImageFile> read = imageOfBytes(image->grid, image->layout, all.substr(std::min(image->offset, all.size())));
  if (!read) return read.error();
  constexpr int kLabels = 1002;  // NIFTI_INTENT_LABEL
  const NiftiHeader header(head, *fields);
  read->labels = labelsInExtensions(all.substr(fields->size, image->offset - fields->size), header.order());
  read->hasLabels = header.code(fields->intent) == kLabels || !read->labels.empty();
  read->remarks.insert(read->remarks.begin(), image->remarks.begin(), image->remarks.end());
  return read;
}

}  // namespace handwheel
