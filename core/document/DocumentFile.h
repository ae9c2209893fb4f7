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

// What a document stores about the file that it was read from.
struct DocumentFile {
  std::string id;           // UUID; made when a document is imported, kept in containers
  std::string path;         // absolute, as bytes; empty for a document that was never saved
  std::string title = {};   // what it is called until it is saved, UTF-8; empty: by its file, if it has one
  std::string copyOf = {};  // as path: the file whose surface it was made of; it is to be saved beside that
  std::optional<FileTimestamp> stamp = {};  // of that file as it was read or written; none where that is not known
  LengthUnit displayUnit = LengthUnit::Millimetre;
  std::vector<StoredRecording> recordings;  // of haptic devices; in the order in which they were made
  AssignedExercise assigned = {};           // that it is work on
  std::vector<Error> damage;                // what was skipped or repaired
  std::size_t unlistedDamage = 0;           // further damage beyond what is listed
  std::vector<LostAttribute> lost;          // what the file holds and the document does not
  std::vector<std::string> lostOther;       // as MeshFile::lostOther
  std::vector<Note> notes;                  // what else there is to know of how it was read
  bool hasUnit = true;                      // false: the format of the file has no unit of length
  bool isContainer = false;
  bool isNewer = false;    // written by a newer program
  bool isPartial = false;  // recovered from an autosave, and the file at the path holds more than the document
  // Keys and blobs that this program does not know; they are written back into the file. And the keys that it knew when
  // it read the file: what was unknown within one of these is removed when that is deleted. Both null if it was not
  // read from a container.
  std::shared_ptr<const Container> unknown;
  std::shared_ptr<const Container> known;

  // Whether overwriting the file would lose something.
  bool wouldLoseDataOnOverwrite() const { return !damage.empty() || !lost.empty() || isNewer || isPartial; }
};

// Result of reading a file on a worker, from which a document is made.
struct OpenedFile {
  const DocumentKind* kind = nullptr;
  DocumentFile file;
  SnapshotPointer content;
};

}  // namespace handwheel
