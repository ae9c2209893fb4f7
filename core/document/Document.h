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

// Whether more edits of the same gesture follow. For example those of a slider that is still held.
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
  // Its title, else the file name; without one that of the file that it is a copy of, without ending, else "Untitled".
  QString name() const;
  std::uint64_t revision() const { return m_revision; }  // grows with every change, undo and redo included

  QUndoStack* history() { return &m_history; }
  const QUndoStack* history() const { return &m_history; }
  bool isModified() const {
    return m_recovered || m_isRecordedAnew || !(m_history.isClean() || (m_isFileBeforeFirst && m_history.index() == 0));
  }
  // To be called after its present state was written to this path; a container keeps id and unknown keys.
  void markSaved(const QString& path, bool isContainer, const std::optional<FileTimestamp>& stamp = {});
  // To be called after an earlier state of it was written to its own file: no state that is known is in the file now.
  void markOverwritten(const std::optional<FileTimestamp>& stamp);
  // Marks it as in no file: restored from an autosave of the document of this path, or made of another one (empty).
  // stamp, isPartial: as DocumentFile has them, of the file at the path.
  void markRecovered(const QString& path, const std::optional<FileTimestamp>& stamp = {}, bool isPartial = false);

  // Sets the exercise that it is work on, and the attempt. No undo step, so that an undo takes back what was made, but
  // no time and no hint. isChange: it is modified then; else the next save takes it along.
  void assign(AssignedExercise assigned, bool isChange);

  // To be called before it is read for good: saved, handed in, closed. What is under way, as the pass of a tool, is
  // committed then.
  void settle() { emit settling(); }

  virtual SnapshotPointer snapshot() const = 0;

  // The properties that can be read, and set, by name. Kinds add theirs before those common to all.
  virtual std::vector<Property> properties() const;
  // The property with this id; none when there is none. Kinds with very many properties find it without making all.
  virtual std::optional<Property> property(const std::string& id) const;
  // An edit that gives a property a new value; null when it has that value already. Errors: ReferenceMissing
  // {property}, ValueOutOfRange, ElementMalformed.
  virtual Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const;
  // Sets a property. A gesture that returns to the initial value leaves no undo step. The same errors.
  Status setProperty(const std::string& id, const PropertyValue& value, DragPhase stroke = DragPhase::Ends);

  // Applies an edit as one undo step, or as part of one: the edits of a gesture become one step as far as they absorb
  // each other. step: as UndoCommand::step().
  void commit(const QString& text, std::unique_ptr<Edit> edit, DragPhase stroke = DragPhase::Ends,
              std::string step = {});

  LengthUnit displayUnit() const { return m_file.displayUnit; }

 signals:
  void changed();      // the value; also by undo and redo
  void fileChanged();  // path, format, clean state, display unit, recordings or attempt
  void settling();     // whoever has something under way in it commits that now

 protected:
  // For constructors of kinds whose files do not come in as they are: what opening does is the first step, applied
  // here. Until the document is saved it counts as unmodified before this step, as the file is, and after it.
  void beginHistory(const QString& text, std::unique_ptr<Edit> edit);

  // To be called by every edit. Classes with signals of their own emit them between countChange() and changed().
  void countChange() { ++m_revision; }
  void wasChanged() {
    countChange();
    emit changed();
  }
  // Of what is recorded and no undo step: it differs from its file then.
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
