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

// Returns the id of a new document: DocumentFile::id.
std::string newDocumentId();

// Result of writing a file.
struct WrittenFile {
  std::size_t bytes = 0;
  std::vector<Note> notes;  // differences between the file and the document, and its state
};

// Interface of a document type: reading, saving, exporting, describing and displaying its documents. No state except
// settings; any thread, except make(). To add a kind, derive from this class and add it to the list in app/builtin.
class DocumentKind {
 public:
  virtual ~DocumentKind() = default;

  virtual std::string id() const = 0;     // in manifests and on the command line: "mesh"
  virtual std::string title() const = 0;  // English, context "DocumentKind": "Mesh"
  virtual std::vector<FileFormat> formats() const = 0;

  // Returns true if a foreign file is of this kind, by its first 64 KiB and its name.
  virtual bool recognises(std::string_view head, std::string_view name) const = 0;
  // Returns true if import() also accepts a folder, such as one with a series of images.
  virtual bool readsFolders() const { return false; }
  virtual Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions& options,
                                    Progress progress) const = 0;
  // Writes a foreign format by the extension of the path: the whole file or nothing.
  virtual Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path,
                                       Progress progress) const = 0;

  // Write and read the part of a container that belongs to this kind: the object manifest["document"], in which save()
  // writes every key it knows, and the blobs in a folder named after the kind. load() must accept any input, and return
  // everything that can be recovered from a damaged file.
  virtual void save(const Snapshot& content, Container& container) const = 0;
  virtual Result<SnapshotPointer> load(const Container& container, std::vector<Error>& damage,
                                       Progress progress) const = 0;

  // Returns the content of a new document of default size; null for a kind without empty documents.
  virtual SnapshotPointer blank() const { return nullptr; }

  // Returns the content after checking the files that it is linked to, for a container in this folder. The results are
  // added to the notes. Kinds without links return the content itself.
  virtual SnapshotPointer withCheckedLinks(SnapshotPointer content, const std::filesystem::path& folder,
                                           std::vector<Note>& notes, Progress progress) const;

  // Returns the files that the content is linked to; they are never replaced by the document. Absolute.
  virtual std::vector<std::filesystem::path> linkedFiles(const Snapshot&) const { return {}; }

  // Returns the shape of a document of this kind as a body in another; null if it has none. Losses are added to the
  // notes. By default its display as one mesh.
  virtual GeometryPointer bodyGeometry(const Snapshot& content, std::vector<Note>& notes) const;

  // Returns true if a document of this kind can be made from the surface of another document; ofSurface() returns its
  // content. source: the name of that document. Errors: Cancelled, and those of the kind.
  virtual bool isMadeOfSurfaces() const { return false; }
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

  // Reads a container or a foreign file of any kind, recognised by content, or a folder (readsFolders()). Errors: those
  // of the readers, FormatUnknown, KindUnknown.
  Result<OpenedFile> open(const std::filesystem::path& path, const ReadOptions& options, Progress progress = {}) const;
  // Reads a container from its bytes. Errors: those of open(), without subject; OutOfMemory.
  Result<OpenedFile> openContainer(std::string_view bytes, Progress progress = {}) const;
  // Returns the file extensions that open() reads: ".stl", …, ".handwheel".
  std::vector<std::string> readEndings() const;
  // Returns the kind of a foreign file, by its first bytes and its name, or of a folder; null for a container. Errors:
  // those of opening it, FormatUnknown.
  Result<const DocumentKind*> kindOf(const std::filesystem::path& path) const;
  // Returns a new, unsaved document of a kind that has blank ones.
  static OpenedFile blank(const DocumentKind& kind);

 private:
  std::vector<std::unique_ptr<DocumentKind>> m_kinds;
};

inline constexpr std::string_view kContainerEnding = ".handwheel";
// Returns true if a file name has the extension of containers.
bool isContainerName(const std::filesystem::path& path);

// Returns the file extensions of the formats that are written, and the container: ".step", …, ".handwheel".
std::vector<std::string> writtenEndings(const std::vector<FileFormat>& formats);
// Returns the error ExtensionUnknown for a path with another extension.
Error unknownEnding(const std::filesystem::path& path, std::vector<std::string> written);

// Saves a document, as a container or in a foreign format, by the path's extension. Writes the whole file or nothing.
// Errors: ExtensionUnknown, VersionNewer (of an existing document, which is never replaced), ReplacesLinked; those of
// the formats; for a container FileTooLarge, CheckFailed, WriteFailed, OutOfMemory, Cancelled.
Result<WrittenFile> saveDocument(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                 const std::filesystem::path& path, Progress progress = {});

// Returns the container that saveDocument() writes, after checking that it can be read. Errors: the same.
Result<std::string> checkedContainer(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                     const std::filesystem::path& path, Progress progress = {});

// Returns the document's container. path: the target file, which links are relative to; may be empty. Errors:
// Cancelled.
Result<Container> containerOf(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                              const std::filesystem::path& path, Progress progress = {});
// Returns the bytes of the container. Errors: those of writeContainer(), too.
Result<std::string> containerBytes(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                   const std::filesystem::path& path, Compression compression, Progress progress = {});

}  // namespace handwheel
