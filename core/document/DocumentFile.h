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
  std::string id;           // UUID; made when a document is imported, kept in containers
  std::string path;         // absolute, as bytes; empty for a document that was never saved
  std::string title = {};   // name until it is saved, UTF-8; empty: the name of its file, if it has one
  std::string copyOf = {};  // path of the file from whose surface it was made; it is to be saved beside that
  std::optional<FileTimestamp> stamp = {};  // stamp of that file when it was read or written; none: unknown
  LengthUnit displayUnit = LengthUnit::Millimetre;
  std::vector<StoredRecording> recordings;  // recordings of haptic devices, in the order of their creation
  AssignedExercise assigned = {};           // the exercise that it belongs to
  std::vector<Error> damage;                // parts that were skipped or repaired
  std::size_t unlistedDamage = 0;           // further damage beyond the listed one
  std::vector<LostAttribute> lost;          // contents of the file that the document does not have
  std::vector<std::string> lostOther;       // see MeshFile::lostOther
  std::vector<Note> notes;                  // other remarks on reading it
  bool hasUnit = true;                      // false: the format of the file has no unit of length
  bool isContainer = false;
  bool isNewer = false;    // written by a newer program
  bool isPartial = false;  // recovered from an autosave, and the file at the path holds more than the document
  // Keys and blobs that this program does not know; they are written back into the file. `known` has the keys that it
  // knew when it read the file: unknown parts within one of these are removed if that is deleted. Both null if it was
  // not read from a container.
  std::shared_ptr<const Container> unknown;
  std::shared_ptr<const Container> known;

  // Returns true if overwriting the file would lose something.
  bool wouldLoseDataOnOverwrite() const { return !damage.empty() || !lost.empty() || isNewer || isPartial; }
};

// Result of reading a file on a worker thread, from which a document is made.
struct OpenedFile {
  const DocumentKind* kind = nullptr;
  DocumentFile file;
  SnapshotPointer content;
};

}  // namespace handwheel
