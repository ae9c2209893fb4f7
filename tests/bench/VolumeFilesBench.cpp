// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MadeDicom.h"
#include "bench/Bars.h"
#include "document/FileBytes.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/VolumeMaking.h"
#include "volume/image/ImageToVolume.h"
#include "volume/image/NrrdWriter.h"
#include "volume/segment/SegmentParts.h"
#include "volume/segment/SlicePicture.h"
#include "volume/surface/VolumeToSurface.h"

#include <QTemporaryDir>
#include <cmath>
#include <fstream>
#include <limits>

using namespace handwheel;

// A CT of 512 × 512 × 300 that is made up, from its files to its surface, beside reading its bytes.
namespace {

namespace fs = std::filesystem;

bench::Bars bars;

constexpr int kAcross = 512, kSlices = 300;
constexpr double kSpacing = 0.5, kStep = 0.7;  // mm

// A skull of 8 mm: air, skin and brain, bone, as a CT has them, but for the noise of half a step.
double skull(const Vec3& p) {
  const Vec3 middle(128.0, 128.0, 60.0);
  const Vec3 q((p.x() - middle.x()) / 80.0, (p.y() - middle.y()) / 100.0, (p.z() - middle.z()) / 130.0);
  const double depth = 90.0 * (1.0 - q.norm());  // mm, nearly
  const double bone = std::clamp(4.0 - std::abs(depth - 10.0), 0.0, 1.0);
  const double tissue = std::clamp(depth, 0.0, 1.0);
  const double noise = 20.0 * std::sin(12.9898 * p.x() + 78.233 * p.y() + 37.719 * p.z());
  return std::round(-1000.0 + 1040.0 * tissue + 1000.0 * bone + noise);
}

struct Files {
  QTemporaryDir folder;
  fs::path nrrd = fs::path(folder.path().toStdString()) / "ct.nrrd";
  fs::path dicom = fs::path(folder.path().toStdString()) / "dicom";

  Files() {
    const ImageGrid grid{
        {kAcross, kAcross, kSlices}, Vec3::Zero(), Vec3(kSpacing, kSpacing, kStep).asDiagonal().toDenseMatrix()};
    fs::create_directory(dicom);
    std::vector<std::int16_t> samples;
    for (int z = 0; z < kSlices; ++z) {
      for (int y = 0; y < kAcross; ++y)
        for (int x = 0; x < kAcross; ++x)
          samples.push_back(static_cast<std::int16_t>(skull(grid.position(Vec3(x, y, z)))));
      test::MadeSlice slice;
      slice.width = slice.height = kAcross;
      slice.spacing = kSpacing;
      slice.origin.z() = kStep * z;
      slice.value = skull;
      std::ofstream(dicom / std::to_string(z), std::ios::binary) << test::dicomOf(slice);
    }
    std::ofstream(nrrd, std::ios::binary) << nrrdOf(ImageVolume(grid, std::move(samples)));
  }
};

void aScan(benchmark::State& state) {
  const Files files;
  bench::Fastest bytes, open, dicom, imported, importedDicom, threshold, surface, preview, parts;
  const ValueRange bone{300.0, std::numeric_limits<double>::infinity()};
  std::size_t triangles = 0;
  for (auto run : state) {
    for (int i = 0; i < 3; ++i) {
      bytes.add(bench::secondsOf([&] { benchmark::DoNotOptimize(readFileBytes(files.nrrd)); }));
      Result<ImageFile> image = Error{}, series = Error{};
      open.add(bench::secondsOf([&] { image = readImageFile(files.nrrd, {}); }));
      dicom.add(bench::secondsOf([&] { series = readImageFile(files.dicom, {}); }));
      // Opens the files like the window: with a volume that is ready to be shown.
      bool areImported = true;
      const auto import = [&](const fs::path& path) {
        std::vector<Note> notes;
        areImported &= importVolume(path, notes, {}).hasValue();
      };
      imported.add(bench::secondsOf([&] { import(files.nrrd); }));
      importedDicom.add(bench::secondsOf([&] { import(files.dicom / "0"); }));  // by one of its slices
      if (!image || !series || !areImported) return bars.failed(state, "CT 512 x 512 x 300", "it cannot be read");
      Result<SparseVolume> volume = Error{};
      threshold.add(bench::secondsOf([&] { volume = volumeOfImage(image->image, bone, std::nullopt); }));
      // Simulates dragging a handle of the histogram: another range, shown in the three slices in the middle.
      preview.add(bench::secondsOf([&] {
        const Segment dragged({250.0 + 10.0 * i, bone.largest});
        for (const SlicePlane plane : kSlicePlanes) {
          const SliceView view = sliceView(image->image.grid(), plane);
          benchmark::DoNotOptimize(
              pictureOf(image->image, dragged, view, view.slices / 2, {500.0, 2000.0}, 0x70ff9d2e).pixels.data());
        }
      }));
      parts.add(bench::secondsOf(
          [&] { benchmark::DoNotOptimize(SegmentParts(image->image, Segment(bone)).samples().data()); }));
      if (!volume) return bars.failed(state, "CT 512 x 512 x 300", "nothing is bone");
      surface.add(bench::secondsOf([&] { triangles = surfaceOf(*volume).triangles.size(); }));
    }
  }
  const std::string ct = "CT 512 x 512 x 300: ";
  const auto ratio = [&](const bench::Fastest& one) { return bench::ratioTo(one.seconds, bytes.seconds); };
  bars.atMost(ct + "opened from NRRD, times reading its bytes", 6.0, ratio(open));
  bars.atMost(ct + "opened from DICOM by another process, times reading its bytes", 45.0, ratio(dicom));
  bars.atMost(ct + "bone as a volume, times reading its bytes", 45.0, ratio(threshold));
  bars.atMost(ct + "its surface, times reading its bytes", 12.0, ratio(surface));
  bars.atMost(ct + "threshold preview in three slices, times reading its bytes", 1.0, ratio(preview));
  bars.atMost(ct + "opened from NRRD as a volume, s", 3.0, imported.seconds);
  bars.atMost(ct + "opened from DICOM as a volume, s", 3.0, importedDicom.seconds);
  bars.atMost(ct + "threshold preview in three slices, s", 0.1, preview.seconds);
  bars.atMost(ct + "bone as a volume and its surface, s", 5.0, threshold.seconds + surface.seconds);
  bars.tell(ct + "parts of the segment, s", parts.seconds);
  bars.tell(ct + "reading its bytes, s", bytes.seconds);
  bars.tell(ct + "opened from NRRD, s", open.seconds);
  bars.tell(ct + "opened from DICOM, s", dicom.seconds);
  bars.tell(ct + "bone as a volume, s", threshold.seconds);
  bars.tell(ct + "its surface, s", surface.seconds);
  bars.tell(ct + "triangles, millions", static_cast<double>(triangles) / 1e6);
}
BENCHMARK(aScan)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
