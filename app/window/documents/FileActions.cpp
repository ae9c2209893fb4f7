// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/FileActions.h"

#include "controls/FocusedField.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileFilters.h"
#include "window/documents/RecentFiles.h"
#include "window/documents/Samples.h"
#include "window/kinds/CompanionFiles.h"
#include "window/kinds/KindUi.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>

namespace handwheel {

namespace {

// "part-2.handwheel", or what number is free.
QString freeName(const DocumentKind& kind, const QString& path) {
  const QFileInfo file(path);
  const QString ending = endingOf(kind, path);
  for (int number = 2;; ++number) {
    const QString name =
        QStringLiteral("%1-%2%3").arg(file.fileName().chopped(ending.size()), QString::number(number), ending);
    if (!file.dir().exists(name)) return file.dir().filePath(name);
  }
}

}  // namespace

FileActions::FileActions(QWidget* window, const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs,
                         JobRunner& jobs, RecentFiles& recent, LogModel& log)
    : QObject(window),
      m_window(window),
      m_kinds(kinds),
      m_uis(uis),
      m_tabs(tabs),
      m_jobs(jobs),
      m_recent(recent),
      m_loader(kinds, uis, tabs, jobs, recent, log),
      m_saver(tabs, jobs, recent, log),
      m_open(tr("&Open…"), this),
      m_save(tr("&Save"), this),
      m_saveAs(tr("Save &as…"), this),
      m_close(tr("&Close"), this),
      m_nextTab(tr("Ne&xt document"), this),
      m_previousTab(tr("&Previous document"), this),
      m_recentMenu(new QMenu(tr("Open &recent"), window)) {
  m_open.setShortcut(QKeySequence::Open);
  m_save.setShortcut(QKeySequence::Save);
  m_saveAs.setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
  m_close.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_W));
  m_nextTab.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageDown));
  m_previousTab.setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageUp));
  prepare(m_open, "openFile", "open", tr("Open files"));
  prepare(m_save, "saveFile", "save", tr("Save this document"));
  prepare(m_saveAs, "saveFileAs", "save-as", tr("Save this document under another name"));
  prepare(m_close, "closeDocument", "close", tr("Close this document"));
  const auto tellKey = [this] { m_tabs.setCloseTip(m_close.toolTip()); };
  connect(&m_close, &QAction::changed, this, tellKey);
  tellKey();
  prepare(m_nextTab, "nextDocument", "next", tr("Go to the next open document"));
  prepare(m_previousTab, "previousDocument", "previous", tr("Go to the previous open document"));
  m_recentMenu->setObjectName(QStringLiteral("recentMenu"));

  connect(&m_open, &QAction::triggered, this, &FileActions::askForFiles);
  connect(&m_save, &QAction::triggered, this, &FileActions::saveCurrent);
  connect(&m_saveAs, &QAction::triggered, this, [this] {
    commitFocusedField();
    askForName(m_tabs.current(), {});
  });
  connect(&m_close, &QAction::triggered, this, [this] { requestClose(m_tabs.current()); });
  connect(&m_nextTab, &QAction::triggered, this, [this] { m_tabs.step(+1); });
  connect(&m_previousTab, &QAction::triggered, this, [this] { m_tabs.step(-1); });
  connect(&m_loader, &FileLoader::message, this, &FileActions::message);
  connect(&m_saver, &FileSaver::message, this, &FileActions::message);
  connect(&m_saver, &FileSaver::succeeded, this, &FileActions::saved);
  connect(&m_saver, &FileSaver::failed, this, &FileActions::offerAnotherName);
  connect(&m_saver, &FileSaver::incomplete, this, &FileActions::offerContainer);
  connect(&m_tabs, &DocumentTabs::currentChanged, this, &FileActions::followDocument);
  connect(&m_tabs, &DocumentTabs::closeRequested, this, [this](DocumentTab* document) { requestClose(document); });
  connect(&m_recent, &RecentFiles::changed, this, &FileActions::fillRecentMenu);
  fillRecentMenu();
  followDocument();
}

void FileActions::add(const std::string& kind, KindUi& ui) {
  for (const StartAction& beginning : ui.startActions()) {
    auto* action = new QAction(beginning.text, this);
    prepare(*action, beginning.id.toLatin1().constData(), beginning.icon.toLatin1().constData(), beginning.tip);
    if (beginning.asks) {
      connect(action, &QAction::triggered, &ui, [&ui, id = beginning.id] { ui.begin(id); });
    } else if (beginning.sample.isEmpty()) {
      connect(action, &QAction::triggered, this, [this, kind] { m_loader.create(kind); });
    } else {
      const QString path = samplePath(beginning.sample);
      action->setEnabled(!path.isEmpty());
      connect(action, &QAction::triggered, this, [this, path] { m_loader.load(path); });
    }
    m_startActions.emplace_back(beginning, action);
  }
}

QList<QAction*> FileActions::startActions(bool isNew) const {
  QList<QAction*> actions;
  for (const auto& [beginning, action] : m_startActions)
    if (beginning.sample.isEmpty() == isNew) actions << action;
  return actions;
}

std::vector<StartTile> FileActions::tiles() const {
  std::vector<StartTile> tiles;
  for (const auto& [beginning, action] : m_startActions) {
    if (!beginning.tile) continue;
    tiles.push_back(*beginning.tile);
    tiles.back().isAvailable = action->isEnabled();
  }
  return tiles;
}

void FileActions::begin(const QString& tile) {
  for (const auto& [beginning, action] : m_startActions) {
    if (beginning.tile && beginning.tile->name == tile) return action->trigger();
  }
}

void FileActions::followDocument() {
  const bool open = m_tabs.current() != nullptr;
  for (QAction* action : {&m_save, &m_saveAs, &m_close}) action->setEnabled(open);
  for (QAction* action : tabSteps()) action->setEnabled(m_tabs.all().size() > 1);
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
  for (const QString& path : paths) {
    // Without a slash at its end, so that a folder has a name.
    const QString absolute = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    const DocumentTab* const current = m_tabs.current();
    if (current && current->ui.take(absolute)) continue;
    if (!offerBeside(absolute)) m_loader.load(absolute);
  }
}

// A file that is no document, but is opened beside one: says so, and offers a new document or one that is open.
bool FileActions::offerBeside(const QString& path) {
  for (const auto& [kind, ui] : m_uis) {
    const auto* const files = dynamic_cast<const CompanionFiles*>(ui.get());
    const auto offer = files ? files->companionOffer(path) : std::nullopt;
    if (!offer) continue;
    Message message{Message::Weight::Warning, offer->title, offer->detail, offer->advice};
    message.actionText = offer->action;
    message.action = [this, path, id = kind] {
      m_loader.create(id);
      m_tabs.current()->ui.take(path);
    };
    for (const auto& tab : m_tabs.all()) {
      if (tab->document.kind().id() != kind) continue;
      message.otherText = tr("Open beside %1").arg(tab->document.name());
      message.other = [this, path, open = tab.get()] {
        if (!m_tabs.contains(open)) return;
        m_tabs.setCurrent(open);
        open->ui.take(path);
      };
    }
    emit this->message(message);
    return true;
  }
  return false;
}

QString FileActions::iconNameFor(const QString& path) const {
  return handwheel::iconNameFor(m_kinds, path);
}

void FileActions::askForFiles() {
  QStringList beside;
  for (const auto& [kind, ui] : m_uis)
    if (const auto* const files = dynamic_cast<const CompanionFiles*>(ui.get())) beside << files->companionFilter();
  auto* dialog = new QFileDialog(m_window, tr("Open files"), lastFolder(),
                                 openFilters(m_kinds, beside).join(QStringLiteral(";;")));
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
  commitFocusedField();
  saveOrAsk(m_tabs.current(), {});
}

// The file itself must not be overwritten without asking: it holds what the document does not, is not the user's, or
// cannot be written by us.
bool FileActions::needsNewName(const DocumentTab& open) const {
  const Document& document = open.document;
  if (document.file().path.empty() || !canWrite(document.kind(), document.path())) return true;
  if (!document.file().recordings.empty() && !isContainerName(document.file().path)) return true;
  if (open.written) return false;
  const QFileInfo file(document.path());
  return document.file().wouldLoseDataOnOverwrite() || file.isDir() || (file.exists() && !file.isWritable()) ||
         isSample(file);
}

void FileActions::saveOrAsk(DocumentTab* document, std::function<void(bool)> ended) {
  if (needsNewName(*document)) return askForName(document, std::move(ended));
  m_saver.save(document, document->document.path(), std::move(ended));
}

void FileActions::askForName(DocumentTab* document, std::function<void(bool)> ended, bool asContainer) {
  auto* dialog = new QFileDialog(m_window, tr("Save as"));
  dialog->setObjectName(QStringLiteral("saveDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setLabelText(QFileDialog::LookIn, tr("Save in:"));
  dialog->setNameFilters(saveFilters(document->document.kind()));
  const bool hasRecordings = !document->document.file().recordings.empty();  // no foreign file holds recordings
  QString suggestion = hasRecordings || asContainer ? document->ui.KindUi::suggestedName(*document)
                                                    : document->ui.suggestedName(*document);
  const bool isCopy = document->document.file().path.empty() && QFileInfo::exists(suggestion);
  if (isCopy || (needsNewName(*document) && suggestion == document->document.path()))
    suggestion = freeName(document->document.kind(), suggestion);
  const bool sample = isSample(QFileInfo(document->document.path()));
  // A document without a file is called by its title alone, which is in no folder.
  const QFileInfo folder(QFileInfo(suggestion).path());
  const bool isOwn = QFileInfo(suggestion).isAbsolute() && folder.isWritable() && !sample;
  dialog->setDirectory(isOwn ? folder.filePath() : lastFolder());
  dialog->selectFile(QFileInfo(suggestion).fileName());
  dialog->setDefaultSuffix(endingOf(document->document.kind(), suggestion));
  connect(dialog, &QFileDialog::filterSelected, dialog,
          [dialog, &kind = document->document.kind()](const QString& chosen) {
            const QString name = QFileInfo(dialog->selectedFiles().value(0)).fileName();
            dialog->selectFile(renamedFor(kind, name, chosen));
            dialog->setDefaultSuffix(endingOf(kind, renamedFor(kind, QStringLiteral("name"), chosen)));
          });
  connect(dialog, &QFileDialog::fileSelected, this, [this, document, ended](const QString& path) {
    if (!m_tabs.contains(document)) return;
    rememberFolder(path);
    m_saver.save(document, path, ended, FileSaver::Changed::Replace);  // the dialog has asked
  });
  if (ended) connect(dialog, &QFileDialog::rejected, this, [ended] { ended(false); });
  dialog->open();
}

void FileActions::offerAnotherName(DocumentTab* document, Message message) {
  message.actionText = tr("Save as…");
  message.action = [this, document] {
    if (m_tabs.contains(document)) askForName(document, {});
  };
  emit this->message(message);
}

void FileActions::offerContainer(DocumentTab* document, Message message) {
  message.actionText = tr("Save as *%1…").arg(containerEnding());
  message.action = [this, document] {
    if (m_tabs.contains(document)) askForName(document, {}, true);
  };
  emit this->message(message);
}

void FileActions::requestClose(DocumentTab* document, std::function<void()> then) {
  const bool isUnderWay = m_closing.contains(document);
  if (!isUnderWay) {
    commitFocusedField();
    emit aboutToClose();
    document->document.settle();
  }
  auto& waiting = m_closing[document];
  if (then) waiting.push_back(std::move(then));
  if (isUnderWay) return;
  decide(document, [this, document](bool isDecided) { endClosing(document, isDecided); });
}

bool FileActions::wouldLose(const DocumentTab& document) {
  return document.document.isModified() || !document.ui.unsavedBeside(document).isEmpty();
}

// First about what is beside the document, then about itself.
void FileActions::decide(DocumentTab* document, std::function<void(bool)> decided) {
  if (wouldLose(*document) && givenAnswer(*document) != CloseAnswer::Discard) m_tabs.setCurrent(document);
  const auto decideItself = [this, document, decided](bool goesOn) {
    if (!goesOn || !m_tabs.contains(document) || !document->document.isModified()) return decided(goesOn);
    ask(*document, document->document.name(), [this, document, decided](CloseAnswer answer) {
      if (answer == CloseAnswer::Save && m_tabs.contains(document)) return saveOrAsk(document, decided);
      decided(answer == CloseAnswer::Discard);
    });
  };
  const QString beside = document->ui.unsavedBeside(*document);
  if (beside.isEmpty()) return decideItself(true);
  ask(*document, beside, [this, document, decideItself](CloseAnswer answer) {
    if (answer == CloseAnswer::Save && m_tabs.contains(document))
      return document->ui.saveBeside(*document, decideItself);
    decideItself(answer == CloseAnswer::Discard);
  });
}

void FileActions::ask(const DocumentTab& document, const QString& name, std::function<void(CloseAnswer)> then) {
  if (const auto given = givenAnswer(document)) return then(*given);
  askBeforeClosing(m_window, name, std::move(then));
}

std::optional<CloseAnswer> FileActions::givenAnswer(const DocumentTab& document) const {
  const auto given = m_answers.find(&document);
  const bool isGiven = given != m_answers.end() && given->second.second == document.document.revision();
  return isGiven ? std::optional(given->second.first) : std::nullopt;
}

void FileActions::endClosing(DocumentTab* document, bool close) {
  const auto closing = m_closing.extract(document);
  if (!close || closing.empty() || !m_tabs.contains(document)) return;
  m_tabs.close(document);
  for (const auto& then : closing.mapped()) then();
}

void FileActions::requestCloseAll(std::function<void()> then) {
  commitFocusedField();
  emit aboutToClose();
  for (const auto& each : m_tabs.all()) each->document.settle();
  if (!m_isAskingAboutAll) askAboutAll(std::move(then));
}

void FileActions::askAboutAll(std::function<void()> then) {
  m_answers.clear();
  std::vector<DocumentTab*> changed;
  QStringList names;
  for (const auto& open : m_tabs.all()) {
    if (m_closing.contains(open.get()) || !wouldLose(*open)) continue;
    const QString beside = open->ui.unsavedBeside(*open), name = open->document.name();
    changed.push_back(open.get());
    names << (beside.isEmpty() || beside == name ? name : QStringLiteral("%1 · %2").arg(name, beside));
  }
  if (changed.size() < 2) return decideNext({}, std::move(then));
  m_isAskingAboutAll = true;
  askBeforeClosing(m_window, names, [this, changed, then = std::move(then)](const QList<CloseAnswer>& answers) {
    m_isAskingAboutAll = false;
    if (answers.contains(CloseAnswer::Cancel)) return;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      if (m_tabs.contains(changed[i]))
        m_answers[changed[i]] = {answers[static_cast<qsizetype>(i)], changed[i]->document.revision()};
    }
    decideNext({}, then);
  });
}

// Nothing is closed before the last answer: who cancels then keeps everything.
void FileActions::decideNext(std::map<const DocumentTab*, std::uint64_t> decided, std::function<void()> then) {
  disconnect(m_afterSaving);
  const auto isUndecided = [&](const auto& open) {
    const auto found = decided.find(open.get());
    const bool isDecided = found != decided.end() && found->second == open->document.revision();
    return m_closing.contains(open.get()) || (wouldLose(*open) && !isDecided);
  };
  const auto& all = m_tabs.all();
  const auto next = std::find_if(all.begin(), all.end(), isUndecided);
  if (next == all.end()) {
    // Exports, reports and copies go on until they are written; meanwhile more may change.
    if (m_jobs.isBusy(Job::Lane::Saving)) {
      m_afterSaving = connect(&m_jobs, &JobRunner::changed, this, [this, decided, then] { decideNext(decided, then); });
      return;
    }
    m_answers.clear();
    while (!all.empty()) m_tabs.close(all.back().get());
    return then();
  }
  DocumentTab* const document = next->get();
  if (const auto closing = m_closing.find(document); closing != m_closing.end()) {
    closing->second.push_back([this, decided, then] { decideNext(decided, then); });
    return;
  }
  m_closing[document];  // a second request to close it waits
  decide(document, [=, this](bool isDecided) mutable {
    m_closing.erase(document);
    if (!isDecided) return m_answers.clear();  // the next request asks again
    if (m_tabs.contains(document)) decided[document] = document->document.revision();
    decideNext(decided, then);
  });
}

}  // namespace handwheel
