// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FileActions.h"

#include "theme/Icons.h"
#include "window/ClosePrompt.h"
#include "window/CommandText.h"
#include "window/DocumentTabs.h"
#include "window/OpenDocument.h"
#include "window/RecentFiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace handwheel {

namespace {

const auto kFolderKey = QStringLiteral("lastFolder");

QString lastFolder() {
  return QSettings().value(kFolderKey, QDir::homePath()).toString();
}

void rememberFolder(const QString& path) {
  QSettings().setValue(kFolderKey, QFileInfo(path).absolutePath());
}

// The file itself must not be overwritten without asking: it holds what the document does not, or is not the user's.
bool needsNewName(const OpenDocument& open) {
  const MeshDocument& document = open.document;
  if (open.written) return false;
  return !document.damage().empty() || !document.lostAttributes().empty() || !QFileInfo(document.path()).isWritable() ||
         QFileInfo(document.path()) == QFileInfo(samplePath());
}

void prepare(QAction& action, const char* name, const char* iconName, const QString& tip) {
  action.setObjectName(QString::fromLatin1(name));
  if (iconName) action.setIcon(icon(QString::fromLatin1(iconName)));
  action.setToolTip(action.shortcut().isEmpty()
                        ? tip
                        : QStringLiteral("%1 (%2)").arg(tip, action.shortcut().toString(QKeySequence::NativeText)));
}

}  // namespace

FileActions::FileActions(QWidget* window, DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log)
    : QObject(window),
      m_window(window),
      m_tabs(tabs),
      m_recent(recent),
      m_loader(tabs, jobs, recent, log),
      m_saver(tabs, jobs, recent, log),
      m_open(tr("&Open…")),
      m_openSample(tr("Open the &sample")),
      m_save(tr("&Save")),
      m_saveAs(tr("Save &as…")),
      m_close(tr("&Close")),
      m_recentMenu(new QMenu(tr("Open &recent"), window)) {
  m_open.setShortcut(QKeySequence::Open);
  m_save.setShortcut(QKeySequence::Save);
  m_saveAs.setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
  m_close.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_W));
  prepare(m_open, "openFile", "open", tr("Open mesh files"));
  prepare(m_openSample, "openSample", "repair", tr("Open the sample scan"));
  prepare(m_save, "saveFile", "save", tr("Save this document"));
  prepare(m_saveAs, "saveFileAs", "save-as", tr("Save this document under another name"));
  prepare(m_close, "closeDocument", "close", tr("Close this document"));
  m_recentMenu->setObjectName(QStringLiteral("recentMenu"));
  m_openSample.setEnabled(!samplePath().isEmpty());

  connect(&m_open, &QAction::triggered, this, &FileActions::askForFiles);
  connect(&m_openSample, &QAction::triggered, this, [this] { m_loader.load(samplePath()); });
  connect(&m_save, &QAction::triggered, this, &FileActions::saveCurrent);
  connect(&m_saveAs, &QAction::triggered, this, [this] { askForName(m_tabs.current(), {}); });
  connect(&m_close, &QAction::triggered, this, [this] { requestClose(m_tabs.current()); });
  connect(&m_loader, &FileLoader::message, this, &FileActions::message);
  connect(&m_saver, &FileSaver::message, this, &FileActions::message);
  connect(&m_tabs, &DocumentTabs::currentChanged, this, &FileActions::followDocument);
  connect(&m_tabs, &DocumentTabs::closeRequested, this, [this](OpenDocument* document) { requestClose(document); });
  connect(&m_recent, &RecentFiles::changed, this, &FileActions::fillRecentMenu);
  fillRecentMenu();
  followDocument();
}

void FileActions::followDocument() {
  const bool open = m_tabs.current() != nullptr;
  for (QAction* action : {&m_save, &m_saveAs, &m_close}) action->setEnabled(open);
}

void FileActions::fillRecentMenu() {
  m_recentMenu->clear();
  for (const QString& path : m_recent.paths()) {
    QAction* entry = m_recentMenu->addAction(QDir::toNativeSeparators(path));
    connect(entry, &QAction::triggered, this, [this, path] { m_loader.load(path); });
  }
  m_recentMenu->addSeparator();
  QAction* clear = m_recentMenu->addAction(tr("&Clear this list"));
  clear->setObjectName(QStringLiteral("clearRecentFiles"));
  connect(clear, &QAction::triggered, &m_recent, &RecentFiles::clear);
  m_recentMenu->setEnabled(!m_recent.paths().isEmpty());
}

void FileActions::openPaths(const QStringList& paths) {
  for (const QString& path : paths) m_loader.load(QFileInfo(path).absoluteFilePath());
}

void FileActions::askForFiles() {
  auto* dialog = new QFileDialog(m_window, tr("Open mesh files"), lastFolder(),
                                 tr("Meshes (*.stl *.ply *.obj *.off);;All files (*)"));
  dialog->setObjectName(QStringLiteral("openDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
    rememberFolder(paths.first());
    openPaths(paths);
  });
  dialog->open();
}

void FileActions::saveCurrent() {
  saveOrAsk(m_tabs.current(), {});
}

void FileActions::saveOrAsk(OpenDocument* document, std::function<void()> then) {
  if (needsNewName(*document)) return askForName(document, std::move(then));
  m_saver.save(document, document->document.path(), std::move(then));
}

void FileActions::askForName(OpenDocument* document, std::function<void()> then) {
  auto* dialog = new QFileDialog(m_window, tr("Save as"));
  dialog->setObjectName(QStringLiteral("saveDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setLabelText(QFileDialog::LookIn, tr("Save in:"));
  dialog->setNameFilters({tr("Meshes (*.stl *.ply *.obj *.off)"), tr("All files (*)")});
  const QString suggestion = repairedName(document->document.path());
  const bool sample = QFileInfo(document->document.path()) == QFileInfo(samplePath());
  const bool writable = QFileInfo(QFileInfo(suggestion).path()).isWritable();
  dialog->setDirectory(writable && !sample ? QFileInfo(suggestion).path() : lastFolder());
  dialog->selectFile(QFileInfo(suggestion).fileName());
  dialog->setDefaultSuffix(QFileInfo(suggestion).suffix());
  connect(dialog, &QFileDialog::fileSelected, this, [this, document, then](const QString& path) {
    if (!m_tabs.contains(document)) return;
    rememberFolder(path);
    m_saver.save(document, path, then);
  });
  dialog->open();
}

void FileActions::requestClose(OpenDocument* document, std::function<void()> then) {
  const auto closeNow = [this, document, then] {
    m_tabs.close(document);
    if (then) then();
  };
  if (!document->document.isModified()) return closeNow();
  m_tabs.setCurrent(document);
  switch (askBeforeClosing(m_window, document->document.name())) {
    case CloseAnswer::Save:
      return saveOrAsk(document, closeNow);
    case CloseAnswer::Discard:
      return closeNow();
    case CloseAnswer::Cancel:
      return;
  }
}

void FileActions::requestCloseAll(std::function<void()> then) {
  if (m_tabs.all().empty()) return then();
  requestClose(m_tabs.all().back().get(), [this, then] { requestCloseAll(then); });
}

QString samplePath() {
  const QString name = QStringLiteral("scan-with-holes.stl");
  for (const QString& folder : {QCoreApplication::applicationDirPath() + QStringLiteral("/../share/handwheel/samples"),
                                QStringLiteral(HANDWHEEL_SOURCE_SAMPLES)}) {
    const QFileInfo file(QDir(folder), name);
    if (file.exists()) return file.canonicalFilePath();
  }
  return {};
}

}  // namespace handwheel
