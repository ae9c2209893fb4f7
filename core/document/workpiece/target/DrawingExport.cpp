// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/DrawingExport.h"

#include "document/AtomicFile.h"
#include "document/DocumentErrors.h"
#include "document/workpiece/target/SheetPdf.h"
#include "machining/target/files/DrawingWriter.h"
#include "machining/target/files/DxfReader.h"
#include "machining/target/files/SvgReader.h"

#include <QtGlobal>

namespace handwheel {

namespace {

constexpr double kSameDrawing = 1e-6;  // mm

std::string drawingEnding(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

// The bytes, if they hold the same section.
Result<std::string> checkedDrawing(std::string bytes, const TargetProfile& section, const Result<Drawing>& drawing) {
  const Result<TargetProfile> back = drawing ? targetIn(*drawing) : Result<TargetProfile>(drawing.error());
  if (!back) return Error{DocumentError::CheckFailed, {"it cannot be opened"}, {}, {}};
  if (!(distanceBetween(section, *back) <= kSameDrawing))
    return Error{DocumentError::CheckFailed, {"its outline differs"}, {}, {}};
  return bytes;
}

Result<std::string> drawingBytes(const TargetProfile& section, const DrawingTitle& title, const std::string& ending) {
  if (ending == ".pdf") return pdfOf(drawingSheet(section, title), title.name);
  std::string bytes = ending == ".dxf" ? dxfOf(section) : svgOf(section);
  const Result<Drawing> back = ending == ".dxf" ? readDxf(bytes) : readSvg(bytes);
  return checkedDrawing(std::move(bytes), section, back);
}

}  // namespace

std::vector<FileFormat> drawingFormats() {
  return {{"DXF", {".dxf"}, false, true}, {"SVG", {".svg"}, false, true}, {"PDF", {".pdf"}, false, true}};
}

bool isDrawingName(const std::filesystem::path& path) {
  const std::string ending = drawingEnding(path);
  return ending == ".dxf" || ending == ".svg" || ending == ".pdf";
}

Result<WrittenFile> exportDrawing(const TargetProfile& section, const DrawingTitle& title,
                                  const std::filesystem::path& path, Progress progress) {
  const Result<std::string> bytes = drawingBytes(section, title, drawingEnding(path));
  if (!bytes) {
    Error error = bytes.error();
    error.subject = path.string();
    return error;
  }
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const Status written = writeFileAtomically(path, *bytes, progress.part(0.5, 1.0));
  if (!written) return written.error();
  return WrittenFile{bytes->size(), {}};
}

}  // namespace handwheel
