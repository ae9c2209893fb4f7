// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Container.h"
#include "document/DisplayModel.h"
#include "document/DocumentFile.h"
#include "document/Note.h"
#include "document/Property.h"
#include "scene/BodyGeometry.h"

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>

namespace handwheel {

class Document;

// A foreign file format (not the container) of one kind of document.
struct FileFormat {
  std::string name;                  // "STL"
  std::vector<std::string> endings;  // lower case with the dot: ".stl"
  bool reads = true;
  bool writes = true;
};

// Creates an id for a new document (DocumentFile::id).
std::string newDocumentId();

// Result of writing a file.
struct WrittenFile {
  std::size_t bytes = 0;
  std::vector<Note> notes;  // differences between the file and the document, and the state of the file
  // Work on the document cannot go on from the file, which has only its shape, a drawing of it, or a part of its
  // content. The document then keeps its own file and its unsaved changes.
  bool isExport = false;
};

// Interface of a document type: reading, saving, exporting, describing and displaying its documents. It has no state
// except settings. The functions may be called on any thread, except make(). To add a kind, derive a class and add it
// to the list in app/builtin.
class DocumentKind {
 public:
  virtual ~DocumentKind() = default;

  virtual std::string id() const = 0;     // in manifests and on the command line: "mesh"
  virtual std::string title() const = 0;  // English, context "DocumentKind": "Mesh"
  virtual std::vector<FileFormat> formats() const = 0;

  // Returns true if a foreign file is of this kind, according to its first 64 KiB and its name.
  virtual bool recognises(std::string_view head, std::string_view name) const = 0;
  // Returns true if import() also accepts a folder, such as one with a series of images.
  virtual bool readsFolders() const { return false; }
  virtual Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                                    Progress progress) const = 0;
  // Writes a file in the foreign format of the path's extension: the whole file or nothing.
  virtual Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                                       Progress progress) const = 0;

  // Writes the part of a container that belongs to this kind: every key that the kind knows in the object
  // manifest["document"], and the blobs in a folder named after the kind. load() reads this part; it must accept any
  // input and return everything that can be recovered from a damaged file.
  virtual void save(const Snapshot& content, Container& container) const = 0;
  virtual Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                                       Progress progress) const = 0;

  // Returns true if the name of a foreign file of this kind may be that of a patient, so that nothing which may leave
  // the machine should contain it.
  virtual bool hasPrivateName(const std::filesystem::path&) const { return false; }

  // Returns the content of a new document of default size; null for a kind without empty documents.
  virtual SnapshotPointer blank() const { return nullptr; }

  // Checks the files that the content of a container in this folder is linked to, and returns the updated content. The
  // results are added to the notes. Kinds without links return the content itself.
  virtual SnapshotPointer withCheckedLinks(SnapshotPointer content, const std::filesystem::path& folder,
                                           std::vector<Note>& notes, Progress progress) const;

  // Returns the absolute paths of the files that the content is linked to. Saving the document never replaces them.
  virtual std::vector<std::filesystem::path> linkedFiles(const Snapshot&) const { return {}; }

  // Returns the shape of a document of this kind for use as a body in another document; null if there is no shape.
  // Losses are added to the notes. By default the shape is display() as one mesh.
  virtual GeometryPointer bodyGeometry(const Snapshot& content, std::vector<Note>& notes) const;

  // Returns true if a document of this kind can be made from the surface of another document.
  virtual bool isMadeOfSurfaces() const { return false; }
  // Returns the content of a document made from the surface of another document. source: the name of the other
  // document. Errors: Cancelled, and further errors of the kind.
  virtual Result<SnapshotPointer> ofSurface(const TriangleSoup& surface, const std::string& source,
                                            Progress progress) const;

  virtual std::unique_ptr<Document> make(OpenedFile opened) const = 0;

  // Returns the output of 'handwheel inspect --json'.
  virtual nlohmann::json describe(const Snapshot& content) const = 0;
  virtual DisplayModel display(const Snapshot& content) const = 0;
};

// The list of document kinds, with operations on files of any kind.
class DocumentKinds {
 public:
  explicit DocumentKinds(std::vector<std::unique_ptr<DocumentKind>> kinds);

  std::span<const std::unique_ptr<DocumentKind>> all() const { return m_kinds; }
  const DocumentKind* withId(std::string_view id) const;  // null if unknown

  // Reads a container or a foreign file of any kind, recognised by content, or a folder (readsFolders()). Errors: the
  // errors of the readers, FormatUnknown, KindUnknown.
  Result<OpenedFile> open(const std::filesystem::path& path, const ReadOptions& options, Progress progress = {}) const;
  // Reads a container from its bytes. Errors: the errors of open(), without a subject; OutOfMemory.
  Result<OpenedFile> openContainer(std::string_view bytes, Progress progress = {}) const;
  // Returns the file extensions that open() reads: ".stl", …, ".handwheel".
  std::vector<std::string> readEndings() const;
  // Returns the kind of a foreign file, according to its first bytes and its name, or of a folder; null for a
  // container. Errors: the errors of readFileHead(), FileEmpty, FormatUnknown.
  Result<const DocumentKind*> kindOf(const std::filesystem::path& path) const;
  // Returns a new, unsaved document of a kind with blank documents.
  static OpenedFile blank(const DocumentKind& kind);

 private:
  std::vector<std::unique_ptr<DocumentKind>> m_kinds;
};

inline constexpr std::string_view kContainerEnding = ".handwheel";
// Returns true if a file name has the extension of containers.
bool isContainerName(const std::filesystem::path& path);

// Returns the file extensions of the formats that are written, followed by that of containers: ".stl", …, ".handwheel".
std::vector<std::string> writtenEndings(const std::vector<FileFormat>& formats);
// Creates the error ExtensionUnknown for a path. written: the extensions that are written.
Error unknownEnding(const std::filesystem::path& path, std::vector<std::string> written);

// Saves a document as a container or in a foreign format, according to the path's extension. Writes the whole file or
// nothing. Errors: ExtensionUnknown, VersionNewer (for an existing document of a newer version, which is never
// replaced), ReplacesLinked, and the errors of the format; for a container FileTooLarge, CheckFailed, WriteFailed,
// OutOfMemory, Cancelled.
Result<WrittenFile> saveDocument(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                 const std::filesystem::path& path, Progress progress = {});

// Returns the bytes of the container that saveDocument() writes, after checking that they can be read. Errors:
// VersionNewer, FileTooLarge, CheckFailed, OutOfMemory, Cancelled, LibraryFailed.
Result<std::string> checkedContainer(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                     const std::filesystem::path& path, Progress progress = {});

// Returns the document's container. path: the target file, to which links are relative; may be empty. Errors:
// Cancelled.
Result<Container> containerOf(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                              const std::filesystem::path& path, Progress progress = {});
// Returns the bytes of the document's container. Errors: the errors of containerOf() and writeContainer().
Result<std::string> containerBytes(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                   const std::filesystem::path& path, Compression compression, Progress progress = {});

}  // namespace handwheel
