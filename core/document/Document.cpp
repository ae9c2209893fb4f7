// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Document.h"

#include "document/DisplayUnitEdit.h"
#include "document/DocumentKind.h"
#include "document/UndoCommand.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cassert>

namespace handwheel {

namespace {

QString labelOf(const Property& property) {
  return property.translated ? QCoreApplication::translate("Property", property.label.c_str())
                             : QString::fromStdString(property.label);
}

QString pathOf(const std::string& bytes) {
  return QFile::decodeName(QByteArray::fromStdString(bytes));
}

// Returns the text of an undo step. A group with a name of its own is one of several objects with such a property.
QString changeText(const Property& property) {
  if (property.groupTranslated) return Document::tr("Change %1").arg(labelOf(property));
  return Document::tr("Change %1 of %2").arg(labelOf(property), QString::fromStdString(property.group));
}

}  // namespace

Document::Document(const DocumentKind& kind, DocumentFile file, QObject* parent)
    : QObject(parent), m_kind(kind), m_file(std::move(file)) {
  connect(&m_history, &QUndoStack::cleanChanged, this, &Document::fileChanged);
}

// A history signals that it is clean when it is destroyed; no receiver may get this from a partly destroyed document.
Document::~Document() {
  m_history.disconnect();
}

QString Document::path() const {
  return pathOf(m_file.path);
}

QString Document::name() const {
  if (!m_file.title.empty()) return QString::fromStdString(m_file.title);
  if (!m_file.path.empty()) return QFileInfo(path()).fileName();
  return m_file.copyOf.empty() ? tr("Untitled") : QFileInfo(pathOf(m_file.copyOf)).completeBaseName();
}

QString Document::sharedName() const {
  return m_file.hasPrivateName ? QCoreApplication::translate("DocumentKind", m_kind.title().c_str()) : name();
}

void Document::markSaved(const QString& path, bool isContainer, const std::optional<FileTimestamp>& stamp) {
  m_file.stamp = stamp;
  m_file.path = QFile::encodeName(path).toStdString();
  m_file.title.clear();
  m_file.hasPrivateName = false;  // the user has chosen the name
  m_file.isContainer = isContainer;
  m_file.isNewer = false;
  m_file.isPartial = false;
  m_file.damage.clear();
  m_file.unlistedDamage = 0;
  m_file.lost.clear();
  m_file.lostOther.clear();
  m_file.notes.clear();
  m_recovered = false;
  m_isRecordedAnew = false;
  m_isFileBeforeFirst = false;
  m_isStroking = false;  // a later edit is a step of its own
  m_history.setClean();
  emit fileChanged();
}

void Document::markOverwritten(const std::optional<FileTimestamp>& stamp) {
  m_file.stamp = stamp;
  m_isFileBeforeFirst = false;
  m_history.resetClean();
  emit fileChanged();
}

void Document::markRecovered(const QString& path, const std::optional<FileTimestamp>& stamp, bool isPartial) {
  m_file.stamp = stamp;
  m_file.isPartial = isPartial;
  m_file.path = QFile::encodeName(path).toStdString();
  m_recovered = true;
  emit fileChanged();
}

void Document::assign(AssignedExercise assigned, bool isChange) {
  m_file.assigned = std::move(assigned);
  if (isChange) wasRecorded();
}

void Document::wasRecorded() {
  m_isRecordedAnew = true;
  countChange();
  emit fileChanged();
}

std::vector<Property> Document::properties() const {
  return {displayUnitProperty(m_file.displayUnit)};
}

std::optional<Property> Document::property(const std::string& id) const {
  std::vector<Property> all = properties();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Property& each) { return each.id == id; });
  return found == all.end() ? std::nullopt : std::optional(std::move(*found));
}

Result<std::unique_ptr<Edit>> Document::propertyEdit(const std::string& id, const PropertyValue& value) const {
  if (id != kDisplayUnitId) return Error{ErrorCode::ReferenceMissing, {"the property", id}, {}, {}};
  return displayUnitEdit(m_file.displayUnit, value);
}

Status Document::setProperty(const std::string& id, const PropertyValue& value, DragPhase stroke) {
  auto edit = propertyEdit(id, value);
  if ((!edit || !*edit) && stroke == DragPhase::Ends) m_isStroking = false;
  if (!edit) return edit.error();
  if (!*edit) return Done{};
  const std::optional<Property> changed = property(id);
  assert(changed);  // propertyEdit() has found it
  push(new UndoCommand(*this, changeText(*changed), std::move(*edit), UndoCommand::Values{changed->value, value}),
       stroke);
  return Done{};
}

void Document::commit(const QString& text, std::unique_ptr<Edit> edit, DragPhase stroke, std::string step) {
  auto* command = new UndoCommand(*this, text, std::move(edit));
  command->setStep(std::move(step));
  push(command, stroke);
}

void Document::beginHistory(const QString& text, std::unique_ptr<Edit> edit) {
  commit(text, std::move(edit));
  m_history.setClean();
  m_isFileBeforeFirst = true;
  // The history itself has only one clean state.
  connect(&m_history, &QUndoStack::indexChanged, this, [this](int index) {
    if (m_isFileBeforeFirst && index <= 1) emit fileChanged();
  });
}

void Document::push(UndoCommand* command, DragPhase stroke) {
  if (!m_isStroking) ++m_stroke;
  m_isStroking = stroke == DragPhase::Continues;
  command->setStroke(m_stroke);
  m_history.push(command);
}

}  // namespace handwheel
