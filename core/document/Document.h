// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/DocumentFile.h"
#include "document/Edit.h"
#include "document/Property.h"

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <optional>

namespace handwheel {

class UndoCommand;

// Phase of a gesture, such as dragging a slider. Either more edits follow, or this is the last edit.
enum class DragPhase { Continues, Ends };

// Base class of documents: a value with a file and an undo history. It must be used on the window thread; work on other
// threads uses a snapshot(), which is cheap. Each kind of document derives a class (mesh/MeshDocument.h, …).
class Document : public QObject {
  Q_OBJECT

 public:
  Document(const DocumentKind& kind, DocumentFile file, QObject* parent = nullptr);
  ~Document() override;

  const DocumentKind& kind() const { return m_kind; }
  const DocumentFile& file() const { return m_file; }
  QString path() const;
  // Returns the title of the document, or else the name of its file, or else the name of the file that it is a copy of,
  // without the extension, or else "Untitled".
  QString name() const;
  // Returns the name for whatever is written or proposed: that of the kind if the name of the file is private.
  QString sharedName() const;
  std::uint64_t revision() const { return m_revision; }  // grows with every change, undo and redo included

  QUndoStack* history() { return &m_history; }
  const QUndoStack* history() const { return &m_history; }
  bool isModified() const {
    return m_recovered || m_isRecordedAnew || !(m_history.isClean() || (m_isFileBeforeFirst && m_history.index() == 0));
  }
  // Records that the present state of the document was written to this path. isContainer: the file is a container.
  // stamp: the stamp of the file.
  void markSaved(const QString& path, bool isContainer, const std::optional<FileTimestamp>& stamp = {});
  // Records that an earlier state of the document was written to its file. The document then counts as modified in
  // every state.
  void markOverwritten(const std::optional<FileTimestamp>& stamp);
  // Marks the document as modified until it is saved. It was restored from an autosave of the document at this path, or
  // made from another document (empty path). stamp, isPartial: see DocumentFile, for the file at the path.
  void markRecovered(const QString& path, const std::optional<FileTimestamp>& stamp = {}, bool isPartial = false);

  // Sets the exercise that the document belongs to, and the attempt. This is no undo step, so that an undo reverts
  // edits but neither time nor hints. isChange: the document becomes modified; otherwise the new values are only
  // included in the next save.
  void assign(AssignedExercise assigned, bool isChange);

  // Commits unfinished work, such as the pass of a tool. Must be called before the document is saved, handed in or
  // closed.
  void settle() { emit settling(); }

  virtual SnapshotPointer snapshot() const = 0;

  // Returns the properties that can be read and set by name. Each kind of document puts its own properties before those
  // of all documents.
  virtual std::vector<Property> properties() const;
  // Returns the property with this id, or nothing. Kinds of documents with very many properties override it, so that
  // not all are created.
  virtual std::optional<Property> property(const std::string& id) const;
  // Returns an edit that gives a property a new value, or null if the property has this value already. Errors:
  // ReferenceMissing {property}, ValueOutOfRange, ElementMalformed.
  virtual Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const;
  // Sets a property. A gesture that returns to the initial value leaves no undo step. Errors: the errors of
  // propertyEdit().
  Status setProperty(const std::string& id, const PropertyValue& value, DragPhase stroke = DragPhase::Ends);

  // Applies an edit as one undo step. The edits of a gesture become one step if they absorb each other. step: see
  // UndoCommand::step().
  void commit(const QString& text, std::unique_ptr<Edit> edit, DragPhase stroke = DragPhase::Ends,
              std::string step = {});

  LengthUnit displayUnit() const { return m_file.displayUnit; }

 signals:
  void changed();      // emitted after every change of the value, undo and redo included
  void fileChanged();  // emitted after a change of path, format, clean state, display unit, recordings or attempt
  void settling();     // receivers must commit unfinished work in the document

 protected:
  // Applies the change that a kind of document makes to a file on opening, as the first undo step. Must be called in
  // the constructor. Until it is saved, the document counts as unmodified both before and after this step.
  void beginHistory(const QString& text, std::unique_ptr<Edit> edit);

  // Increments the revision. Every edit must call it, or wasChanged(). Classes with signals of their own emit them
  // between countChange() and changed().
  void countChange() { ++m_revision; }
  void wasChanged() {
    countChange();
    emit changed();
  }
  // Marks the document as modified. Must be called after changes without an undo step.
  void wasRecorded();

 private:
  friend class DisplayUnitEdit;
  friend class RecordingsEdit;
  void push(UndoCommand* command, DragPhase stroke);

  const DocumentKind& m_kind;
  DocumentFile m_file;
  std::uint64_t m_revision = 1;
  int m_stroke = 0;
  bool m_isStroking = false;
  bool m_recovered = false;
  bool m_isFileBeforeFirst = false;  // not saved since beginHistory()
  bool m_isRecordedAnew = false;     // wasRecorded() was called since the last save
  QUndoStack m_history;
};

}  // namespace handwheel
