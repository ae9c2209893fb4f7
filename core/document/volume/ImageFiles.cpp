// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/ImageFiles.h"

#include "base/NumberText.h"
#include "document/DocumentErrors.h"
#include "document/FileBytes.h"
#include "process/SystemMemory.h"
#include "volume/VolumeErrors.h"
#include "volume/image/DicomReader.h"
#include "volume/image/ImageHeader.h"
#include "volume/image/ImageLabels.h"
#include "volume/image/MetaImageReader.h"
#include "volume/image/NiftiReader.h"
#include "volume/image/NrrdReader.h"
#include "volume/image/RawImageReader.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

namespace fs = std::filesystem;

bool isDicomFile(const fs::path& path) {
  const Result<std::string> head = readFileHead(path, kDicomHead);
  return head && looksLikeDicom(*head);
}

// Returns true for the directory of a medium, which contains no image (PS3.10, 8.6).
bool isDirectoryFile(const fs::path& path) {
  return imageHeader::lowered(path.filename().string()) == "dicomdir";
}

// Adds the files of a folder, and those of its folders if isDeep is true. Links to folders are not followed.
Status addFiles(const fs::path& folder, bool isDeep, std::vector<fs::path>& paths) {
  constexpr std::size_t kMostFiles = 20'000;
  constexpr int kDeepest = 16;
  std::error_code failed;
  fs::recursive_directory_iterator each(folder, fs::directory_options::skip_permission_denied, failed);
  for (const fs::recursive_directory_iterator end; !failed && each != end; each.increment(failed)) {
    std::error_code ignored;
    if (each->is_directory(ignored)) {
      if (!isDeep || each.depth() >= kDeepest) each.disable_recursion_pending();
      continue;
    }
    if (!isDirectoryFile(each->path())) paths.push_back(each->path());
    if (paths.size() > kMostFiles)
      return Error{
          ErrorCode::FileTooLarge, {"files in the folder", "", std::to_string(kMostFiles)}, {}, folder.string()};
  }
  if (failed) return Error{ErrorCode::FileUnreadable, {failed.message()}, {}, folder.string()};
  return Done{};
}

// Returns the files of a folder that begin as DICOM, sorted by name, with a limit of their total size. With a first
// file, they are that one and those beside it; otherwise those in the folder at any depth.
Result<std::string> dicomFiles(const fs::path& folder, const fs::path& first, Progress progress) {
  constexpr std::size_t kMostBytes = std::size_t{4} << 30;
  const std::size_t most = std::min(kMostBytes, systemMemory() / 4);
  std::vector<fs::path> paths;
  if (const Status added = addFiles(folder, first.empty(), paths); !added) return added.error();
  std::sort(paths.begin(), paths.end());
  if (!first.empty()) {
    std::erase(paths, first);
    paths.insert(paths.begin(), first);
  }
  const Error cancelled{ErrorCode::Cancelled, {}, {}, {}};
  std::vector<fs::path> dicoms;
  std::size_t size = 0;  // total size in the input of the reader
  std::size_t seen = 0;
  for (const fs::path& path : paths) {
    if (progress.cancelled()) return cancelled;
    progress.part(0.0, 0.3).set(static_cast<double>(seen++) / static_cast<double>(paths.size()));
    if (!isDicomFile(path)) continue;
    std::error_code ignored;
    size += sizeof(std::uint64_t) + std::min<std::size_t>(fs::file_size(path, ignored), most);
    if (size > most)
      return Error{ErrorCode::FileTooLarge,
                   {"bytes of DICOM files", std::to_string(size), std::to_string(most)},
                   {},
                   folder.string()};
    dicoms.push_back(path);
  }
  std::string files;
  files.reserve(size);
  std::size_t done = 0;
  for (const fs::path& path : dicoms) {
    if (progress.cancelled()) return cancelled;
    progress.part(0.3, 1.0).set(static_cast<double>(done++) / static_cast<double>(dicoms.size()));
    const Result<std::string> bytes = readFileBytes(path);
    if (!bytes) return bytes.error();
    appendDicomFile(*bytes, files);
  }
  if (files.empty()) return Error{VolumeErrors::FolderWithoutSeries, {}, {}, folder.string()};
  return files;
}

// Reads files beside a header. The samples are made beside their bytes, so these may need half of the memory.
SiblingFile besideHeader(const fs::path& header) {
  return [folder = header.parent_path()](const std::string& name, std::size_t most) -> Result<std::string> {
    const fs::path relative(name);
    const bool leaves = relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end();
    if (leaves) return Error{ErrorCode::Unsupported, {"a data file outside of the folder"}, {}, {}};
    const fs::path path = folder / relative;
    std::error_code failed;
    const auto size = fs::file_size(path, failed);
    const std::size_t wanted = failed ? 1 : static_cast<std::size_t>(std::min(most, size)),
                      allowed = systemMemory() / 2;
    if (wanted > allowed)
      return Error{ErrorCode::FileTooLarge,
                   {"bytes of the data file", std::to_string(wanted), std::to_string(allowed)},
                   {},
                   path.string()};
    Result<std::string> bytes = readFileHead(path, wanted);
    if (bytes) return bytes;
    Error error = bytes.error();
    error.subject = path.string();
    return error;
  };
}

Note noteOn(const ImageRemark& remark) {
  Note note;
  switch (remark.kind) {
    case ImageRemark::Kind::NoSpacing:
      note.text = QT_TRANSLATE_NOOP("Note", "The file does not give the spacing of its samples: 1 mm is assumed.");
      break;
    case ImageRemark::Kind::NotNumbers:
      note.text = QT_TRANSLATE_NOOP("Note", "Samples that are not numbers were replaced by the smallest value (%1).");
      break;
    case ImageRemark::Kind::FirstOfSeveral:
      note.text =
          QT_TRANSLATE_NOOP("Note", "The file contains several values or images (%1); only the first was read.");
      break;
    case ImageRemark::Kind::Tilted:
      note.text = QT_TRANSLATE_NOOP(
          "Note", "The slices are tilted by %1° against their stacking direction; this was corrected.");
      break;
    case ImageRemark::Kind::Uneven:
      note.text = QT_TRANSLATE_NOOP(
          "Note", "The spacing of the slices varies from %1 to %2 mm; slices every %3 mm were interpolated.");
      break;
    case ImageRemark::Kind::SpacingAssumed:
      note.text = QT_TRANSLATE_NOOP("Note",
                                    "The positions of the slices are not stated: a spacing of %1 mm is assumed. The "
                                    "order of the slices, and so left and right, may be reversed.");
      break;
    case ImageRemark::Kind::SlicesMissing:
      note.text = QT_TRANSLATE_NOOP("Note",
                                    "Slices are missing (%1); they were interpolated from their neighbours, which are "
                                    "up to %2 mm apart. What begins or ends between these is not known.");
      break;
    case ImageRemark::Kind::OtherSeries:
      note.text = QT_TRANSLATE_NOOP("Note", "Slices of other series were ignored (%1).");
      break;
    case ImageRemark::Kind::SamePosition:
      note.text = QT_TRANSLATE_NOOP("Note", "Slices at the position of another slice were ignored (%1).");
      break;
    case ImageRemark::Kind::Overlap:
      note.text = QT_TRANSLATE_NOOP(
          "Note", "Segments overlap in %1 samples, which were given to the last of these segments in the file.");
      break;
    case ImageRemark::Kind::Contradiction:
      note.text = QT_TRANSLATE_NOOP("Note",
                                    "The file states two different positions or orientations of its samples (sform and "
                                    "qform); the sform was used. Check left and right.");
      break;
    case ImageRemark::Kind::NotReadable:
      note.text = QT_TRANSLATE_NOOP("Note", "Files that are damaged, or are not greyscale images, were ignored (%1).");
      break;
  }
  constexpr int kDigits = 6;
  constexpr double kLargestCount = 1e15;
  for (const double figure : remark.figures) {
    const bool isCount = figure == std::floor(figure) && std::abs(figure) < kLargestCount;
    note.arguments.push_back(isCount ? std::to_string(static_cast<long long>(figure)) : roundedText(figure, kDigits));
  }
  return note;
}

Result<ImageFile> imageInFile(std::string_view bytes, const SiblingFile& sibling) {
  if (looksLikeNrrd(bytes)) return readNrrd(bytes, sibling);
  if (looksLikeNifti(bytes)) return readNifti(bytes);
  if (looksLikeMetaImage(bytes)) return readMetaImage(bytes, sibling);
  return readRawImage(bytes, sibling);
}

// Returns true if the name of a file says that it holds labels, as 3D Slicer names them.
bool isSegmentation(const fs::path& path) {
  const std::string name = imageHeader::lowered(path.filename().string());
  return name.ends_with(".seg.nrrd") || name.ends_with(".seg.nhdr");
}

// Returns the name of the format of an image or of a folder of images; null for any other file.
const char* formatOf(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return "DICOM";
  const Result<std::string> head = readFileHead(path, kDicomHead);
  if (!head) return nullptr;
  if (looksLikeNrrd(*head)) return "NRRD";
  if (looksLikeNifti(*head)) return "NIfTI";
  if (looksLikeDicom(*head)) return "DICOM";
  if (looksLikeMetaImage(*head)) return "MetaImage";
  return looksLikeRawImage(*head) ? "Raw image" : nullptr;
}

}  // namespace

bool looksLikeImage(std::string_view head) {
  return looksLikeNrrd(head) || looksLikeMetaImage(head) || looksLikeNifti(head) || looksLikeDicom(head) ||
         looksLikeRawImage(head);
}

Result<ImageFile> readImageFile(const fs::path& path, Progress progress) {
  std::error_code ignored;
  if (isDirectoryFile(path) && !fs::is_directory(path, ignored))
    return readImageFile(fs::absolute(path, ignored).parent_path(), progress);
  const bool isFolder = fs::is_directory(path, ignored);
  Result<std::string> head = isFolder ? std::string() : readFileHead(path);
  if (!head) return head.error();
  if (isFolder || looksLikeDicom(*head)) {
    const fs::path whole = fs::absolute(path, ignored);
    Result<std::string> files = isFolder ? dicomFiles(whole, {}, progress.part(0.0, 0.3))
                                         : dicomFiles(whole.parent_path(), whole, progress.part(0.0, 0.3));
    if (!files) return files.error();
    Result<ImageFile> read =
        readDicom(*files, isFolder ? DicomChoice::Largest : DicomChoice::OfFirst, progress.part(0.3, 1.0));
    if (read && read->hasLabels) markLabels(read->image, read->labels);
    return read;
  }
  if (!looksLikeImage(*head)) return Error{DocumentError::FormatUnknown, {".nrrd", ".mhd", ".nii", ".dcm"}, {}, {}};
  const Result<std::string> bytes = readFileBytes(path, progress.part(0.0, 0.5));
  if (!bytes) return bytes.error();
  Result<ImageFile> read = imageInFile(*bytes, besideHeader(path));
  if (read && (read->hasLabels || isSegmentation(path) || looksLikeLabels(read->image)))
    markLabels(read->image, read->labels);
  return read;
}

std::vector<Note> notesOn(std::span<const ImageRemark> remarks) {
  std::vector<Note> notes;
  std::transform(remarks.begin(), remarks.end(), std::back_inserter(notes), noteOn);
  return notes;
}

bool isPrivateName(const fs::path& path) {
  return formatOf(path) != nullptr;
}

std::string sourceName(const fs::path& path) {
  const char* const format = formatOf(path);
  return format ? format : path.filename().string();
}

std::string seriesTitle(const fs::path& path) {
  std::error_code failed;
  const fs::path whole = fs::absolute(path, failed).lexically_normal();
  if (fs::is_directory(whole, failed)) return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
  if (!isDicomFile(whole)) return {};
  for (fs::directory_iterator each(whole.parent_path(), failed), end; !failed && each != end; each.increment(failed))
    if (each->path() != whole && isDicomFile(each->path())) return whole.parent_path().filename().string();
  return {};
}

}  // namespace handwheel
