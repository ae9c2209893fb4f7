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

// Phase of a gesture. It continues while more edits follow, as of a slider that is still held.
enum class DragPhase { Continues, Ends };

// Base class of documents: a value with a file and an undo history. Window thread; work on other threads takes a
// snapshot(), which is cheap. Each kind of document derives from it (mesh/MeshDocument.h, …).
class Document : public QObject {
  Q_OBJECT

 public:
  Document(const DocumentKind& kind, DocumentFile file, QObject* parent = nullptr);
  ~Document() override;

  const DocumentKind& kind() const { return m_kind; }
  const DocumentFile& file() const { return m_file; }
  QString path() const;
  // Returns its title, otherwise the file name; without a file the name of the file that it is a copy of, without
  // extension, otherwise "Untitled".
  QString name() const;
  std::uint64_t revision() const { return m_revision; }  // grows with every change, undo and redo included

  QUndoStack* history() { return &m_history; }
  const QUndoStack* history() const { return &m_history; }
  bool isModified() const {
    return m_recovered || m_isRecordedAnew || !(m_history.isClean() || (m_isFileBeforeFirst && m_history.index() == 0));
  }
  // Must be called after its present state was written to this path; a container keeps id and unknown keys.
  void markSaved(const QString& path, bool isContainer, const std::optional<FileTimestamp>& stamp = {});
  // Must be called after an earlier state was written to its own file: the file then has no known state.
  void markOverwritten(const std::optional<FileTimestamp>& stamp);
  // Marks it as being in no file: restored from an autosave of the document of this path, or made from another one
  // (empty). stamp, isPartial: see DocumentFile, for the file at the path.
  void markRecovered(const QString& path, const std::optional<FileTimestamp>& stamp = {}, bool isPartial = false);

  // Sets the exercise that it belongs to, and the attempt. No undo step, so that an undo reverts edits but neither time
  // nor hints. isChange: it is modified then; otherwise the next save includes it.
  void assign(AssignedExercise assigned, bool isChange);

  // Must be called before the document is saved, handed in or closed. Unfinished work, such as the pass of a tool, is
  // then committed.
  void settle() { emit settling(); }

  virtual SnapshotPointer snapshot() const = 0;

  // Returns the properties that can be read and set by name. Kinds add theirs before those common to all.
  virtual std::vector<Property> properties() const;
  // Returns the property with this id, or none. Kinds with very many properties find it without creating all.
  virtual std::optional<Property> property(const std::string& id) const;
  // Returns an edit that gives a property a new value; null if it has that value already. Errors: ReferenceMissing
  // {property}, ValueOutOfRange, ElementMalformed.
  virtual Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const;
  // Sets a property. A gesture that returns to the initial value leaves no undo step. Errors: those of propertyEdit().
  Status setProperty(const std::string& id, const PropertyValue& value, DragPhase stroke = DragPhase::Ends);

  // Applies an edit as one undo step, or as part of one: the edits of a gesture become one step if they absorb each
  // other. step: see UndoCommand::step().
  void commit(const QString& text, std::unique_ptr<Edit> edit, DragPhase stroke = DragPhase::Ends,
              std::string step = {});

  LengthUnit displayUnit() const { return m_file.displayUnit; }

 signals:
  void changed();      // the value changed; also by undo and redo
  void fileChanged();  // path, format, clean state, display unit, recordings or attempt
  void settling();     // receivers with unfinished work in it commit that now

 protected:
  // For constructors of kinds that change their files on opening: this change is the first step, applied here. Until
  // the document is saved it counts as unmodified both before and after this step.
  void beginHistory(const QString& text, std::unique_ptr<Edit> edit);

  // Must be called by every edit. Classes with signals of their own emit them between countChange() and changed().
  void countChange() { ++m_revision; }
  void wasChanged() {
    countChange();
    emit changed();
  }
  // Must be called after changes that are recorded without an undo step: the document then differs from its file.
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
  bool m_isFileBeforeFirst = false;  // beginHistory(), and not saved since
  bool m_isRecordedAnew = false;     // wasRecorded() since it was saved
  QUndoStack m_history;
};

}  // namespace handwheel
