// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Units.h"
#include "document/AssignedExercise.h"
#include "document/FileTimestamp.h"
#include "document/Note.h"
#include "document/Snapshot.h"
#include "document/StoredRecording.h"
#include "document/formats/MeshFormat.h"

#include <memory>
#include <string>
#include <vector>

namespace handwheel {

struct Container;
class DocumentKind;

// Data of a document about the file that it was read from.
struct DocumentFile {
  std::string id;          // UUID; made when a document is imported, and stored in containers
  std::string path;        // absolute, as bytes; empty for a document without a file
  std::string title = {};  // name of the document until it is saved, UTF-8; empty: the name of its file, if any
  // True: the name may be that of a patient, as folders and files of DICOM are called. The window shows it, but nothing
  // that is written or proposed contains it.
  bool hasPrivateName = false;
  // Path of the file from whose surface the document was made; its folder is suggested for saving.
  std::string copyOf = {};
  std::optional<FileTimestamp> stamp = {};  // stamp of the file when it was last read or written; nothing: unknown
  LengthUnit displayUnit = LengthUnit::Millimetre;
  std::vector<StoredRecording> recordings;  // recordings of haptic devices, in the order of their creation
  AssignedExercise assigned = {};           // the exercise that the document belongs to
  std::vector<Error> damage;                // parts that were skipped or repaired
  std::size_t unlistedDamage = 0;           // number of further parts that are not listed
  std::vector<LostAttribute> lost;          // contents of the file that the document does not keep
  std::vector<std::string> lostOther;       // see MeshFile::lostOther
  std::vector<Note> notes;                  // other remarks on reading the file
  bool hasUnit = true;                      // false: the format of the file has no unit of length
  bool isContainer = false;
  bool isNewer = false;    // written by a newer program
  bool isPartial = false;  // recovered from an autosave; the file at the path contains more than the document
  // Keys and blobs that this program does not know; they are written back into the file. `known` contains the keys that
  // the program knew when it read the file; if one of these is deleted, the unknown parts within it are removed. Both
  // pointers are null if the document was not read from a container.
  std::shared_ptr<const Container> unknown;
  std::shared_ptr<const Container> known;

  // Returns true if overwriting the file would lose some of its content.
  bool wouldLoseDataOnOverwrite() const { return !damage.empty() || !lost.empty() || isNewer || isPartial; }
};

// Result of reading a file on a worker thread. A document is made from it.
struct OpenedFile {
  const DocumentKind* kind = nullptr;
  DocumentFile file;
  SnapshotPointer content;
};

}  // namespace handwheel
