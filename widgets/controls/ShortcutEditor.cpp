// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ShortcutEditor.h"

#include "controls/ShortcutModel.h"
#include "document/AtomicFile.h"
#include "text/ErrorText.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QTreeView>

namespace handwheel {

namespace {

constexpr int kKeyGap = 8;

QPushButton* button(const char* name, const QString& text, const QString& toolTip, QWidget* parent) {
  auto* result = new QPushButton(text, parent);
  result->setObjectName(QString::fromLatin1(name));
  result->setToolTip(toolTip);
  result->setAutoDefault(false);
  return result;
}

}  // namespace

ShortcutEditor::ShortcutEditor(ShortcutModel* model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_list(new QTreeView(this)),
      m_keys(new QKeySequenceEdit(this)),
      m_none(button("shortcutNone", tr("No key"), tr("The command has no key any more"), this)),
      m_reset(button("shortcutReset", tr("Reset"), tr("Restore the default key"), this)),
      m_take(button("shortcutTake", tr("Reassign"), tr("The other commands lose this key"), this)),
      m_status(new QLabel(this)) {
  setObjectName(QStringLiteral("shortcutEditor"));
  m_filtered.setSourceModel(model);
  m_filtered.setFilterKeyColumn(-1);
  m_filtered.setFilterCaseSensitivity(Qt::CaseInsensitive);
  auto* search = new QLineEdit(this);
  search->setObjectName(QStringLiteral("shortcutSearch"));
  search->setPlaceholderText(tr("Search by name or key"));
  search->setAccessibleName(tr("Search commands and keys"));
  search->setClearButtonEnabled(true);
  connect(search, &QLineEdit::textChanged, &m_filtered, &QSortFilterProxyModel::setFilterFixedString);
  m_list->setObjectName(QStringLiteral("shortcutList"));
  m_list->setAccessibleName(tr("Commands and their keys"));
  m_list->setModel(&m_filtered);
  m_list->setRootIsDecorated(false);
  m_list->setUniformRowHeights(true);
  m_list->header()->setSectionResizeMode(ShortcutModel::Command, QHeaderView::Stretch);
  m_list->header()->setSectionResizeMode(ShortcutModel::Keys, QHeaderView::ResizeToContents);
  m_list->header()->setStretchLastSection(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kKeyGap);
  column->addWidget(search);
  column->addWidget(m_list, 1);
  buildKeyLine(*column);
  m_status->setObjectName(QStringLiteral("shortcutStatus"));
  m_status->setWordWrap(true);
  column->addWidget(m_status);
  buildFileLine(*column);
  connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &ShortcutEditor::showRow);
  connect(model, &ShortcutModel::dataChanged, this, &ShortcutEditor::showRow);
  connect(model, &ShortcutModel::modelReset, this, &ShortcutEditor::showRow);
  showRow();
}

void ShortcutEditor::buildKeyLine(QLayout& column) {
  m_keys->setObjectName(QStringLiteral("shortcutKeys"));
  m_keys->setAccessibleName(tr("New key of the chosen command"));
  m_keys->setToolTip(tr("Press the new key here"));
  auto* line = new QHBoxLayout;
  line->setSpacing(kKeyGap);
  line->addWidget(m_keys, 1);
  for (QPushButton* part : {m_take, m_none, m_reset}) line->addWidget(part);
  column.addItem(line);
  connect(m_keys, &QKeySequenceEdit::editingFinished, this, &ShortcutEditor::useKey);
  connect(m_none, &QPushButton::clicked, this, [this] { m_model->setKeys(row(), {}); });
  connect(m_reset, &QPushButton::clicked, this, [this] { m_model->reset(row()); });
  connect(m_take, &QPushButton::clicked, this, [this] { m_model->resolveInFavourOf(row()); });
}

void ShortcutEditor::buildFileLine(QLayout& column) {
  auto* all = button("shortcutResetAll", tr("Reset all"), tr("Restore all default keys"), this);
  auto* read = button("shortcutImport", tr("Import…"), tr("Read the keys from a file"), this);
  auto* write = button("shortcutExport", tr("Export…"), tr("Write the changed keys to a file"), this);
  auto* line = new QHBoxLayout;
  line->setSpacing(kKeyGap);
  line->addWidget(all);
  line->addStretch();
  line->addWidget(read);
  line->addWidget(write);
  column.addItem(line);
  connect(all, &QPushButton::clicked, m_model, &ShortcutModel::resetAll);
  connect(read, &QPushButton::clicked, this, &ShortcutEditor::importFile);
  connect(write, &QPushButton::clicked, this, &ShortcutEditor::exportFile);
}

int ShortcutEditor::row() const {
  return m_filtered.mapToSource(m_list->currentIndex()).row();
}

void ShortcutEditor::showRow() {
  const int chosen = row();
  for (QWidget* part : std::initializer_list<QWidget*>{m_keys, m_none, m_reset}) part->setEnabled(chosen >= 0);
  const QStringList others =
      chosen < 0 ? QStringList() : m_model->index(chosen, 0).data(ShortcutModel::ConflictRole).toStringList();
  m_take->setVisible(!others.isEmpty());
  if (chosen < 0) {
    m_keys->clear();
    return say(tr("Choose a command to change its key."), false);
  }
  const QList<QKeySequence> keys = m_model->keys(chosen);
  m_keys->setKeySequence(keys.isEmpty() ? QKeySequence() : keys.first());
  const bool fixed = m_model->index(chosen, 0).data(ShortcutModel::FixedRole).toBool();
  m_keys->setEnabled(!fixed);
  m_none->setEnabled(!fixed && !keys.isEmpty());
  m_reset->setEnabled(m_model->index(chosen, 0).data(ShortcutModel::ChangedRole).toBool());
  if (fixed) return say(m_model->index(chosen, 0).data(Qt::ToolTipRole).toString(), false);
  if (others.isEmpty()) return say({}, false);
  const QString names = others.join(tr("”, “"));
  if (m_model->index(chosen, 0).data(ShortcutModel::AmbiguousRole).toBool())
    return say(tr("“%1” has the same key, so neither works.").arg(names), true);
  say(tr("“%1” has the same key. In the view, the key acts on the active tool.").arg(names), true);
}

void ShortcutEditor::useKey() {
  const QKeySequence key = m_keys->keySequence();
  if (row() < 0 || key.isEmpty() || m_model->keys(row()).startsWith(key)) return;
  if (const QString why = m_model->objection(row(), key); !why.isEmpty()) {
    showRow();
    return say(why, true);
  }
  m_model->setKeys(row(), {key});
}

void ShortcutEditor::importFile() {
  auto* dialog = new QFileDialog(this, tr("Import keys"), {}, tr("Keys (*.json)"));
  dialog->setObjectName(QStringLiteral("shortcutImportDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    QFile file(path);
    const QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.read(kLargestShortcutFile + 1) : QByteArray();
    const Result<ShortcutChanges> changes = shortcutsFromJson(bytes);
    if (!changes) return say(errorSentence(changes.error()), true);
    m_model->setChanges(*changes);
    say(tr("The keys were imported."), false);
  });
  dialog->open();
}

void ShortcutEditor::exportFile() {
  auto* dialog = new QFileDialog(this, tr("Export keys"), QStringLiteral("keys.json"), tr("Keys (*.json)"));
  dialog->setObjectName(QStringLiteral("shortcutExportDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("json"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    const Status written = writeFileAtomically(path.toStdString(), toJson(m_model->changes()).toStdString());
    say(written ? tr("The changed keys were exported.") : errorSentence(written.error()), !written);
  });
  dialog->open();
}

void ShortcutEditor::say(const QString& what, bool wrong) {
  m_status->setProperty("bad", wrong);
  m_status->setProperty("muted", !wrong);
  m_status->style()->unpolish(m_status);
  m_status->style()->polish(m_status);
  m_status->setText(what);
  m_status->setVisible(!what.isEmpty());
}

}  // namespace handwheel
