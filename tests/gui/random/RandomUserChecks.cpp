// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The checks of RandomUser: history and files.
#include "RandomUser.h"
#include "document/Container.h"
#include "document/DocumentKind.h"
#include "window/MainWindow.h"
#include "window/documents/DocumentTabs.h"

#include <QtTest>
#include <nlohmann/json.hpp>

namespace handwheel::test {

namespace {

std::string contentOf(const DocumentTab& open) {
  DocumentFile file;
  file.id = "random";
  file.displayUnit = open.document.displayUnit();
  const auto bytes =
      containerBytes(open.document.kind(), file, *open.document.snapshot(), {}, Compression::None, Progress());
  return bytes ? *bytes : std::string();
}

// Returns the difference of two containers. Proofs of paths are knowledge of a state, not a part of it: no undo takes
// them back.
QString difference(const std::string& before, const std::string& after) {
  const auto first = readContainer(before), second = readContainer(after);
  if (!first || !second) return QStringLiteral("not read");
  constexpr const char* kProofs = "cell/proofs.json";
  QStringList all;
  for (const auto& each : nlohmann::json::diff(*first->container.manifest, *second->container.manifest))
    all << QString::fromStdString(each.dump()).left(200);
  for (const auto& [name, bytes] : first->container.blobs) {
    if (name == kProofs) continue;
    const auto found = second->container.blobs.find(name);
    if (found == second->container.blobs.end())
      all << QStringLiteral("without %1").arg(QString::fromStdString(name));
    else if (found->second != bytes)
      all << QStringLiteral("another %1").arg(QString::fromStdString(name));
  }
  for (const auto& [name, bytes] : second->container.blobs)
    if (name != kProofs && !first->container.blobs.contains(name))
      all << QStringLiteral("with %1").arg(QString::fromStdString(name));
  return all.join(QStringLiteral(", "));
}

}  // namespace

void RandomUser::keepOpened(const DocumentTab& open) {
  const QUndoStack& history = *open.document.history();
  m_opened[&open] = {contentOf(open), history.index(), history.undoText()};
}

bool RandomUser::goToOpened(const DocumentTab& of) const {
  QUndoStack& history = *of.document.history();
  const Opened& opened = m_opened.at(&of);
  const bool isThere =
      opened.index <= history.count() && (opened.index == 0 || history.text(opened.index - 1) == opened.step);
  if (isThere) history.setIndex(opened.index);
  return isThere;
}

// While nothing runs: no job left anything behind, the history leads there and back, and files hold what was saved.
void RandomUser::check() {
  if (m_window.findChild<QWidget*>(QStringLiteral("jobBar"))->isVisible())
    m_problems << QStringLiteral("a job is shown although none runs");
  const DocumentTab* const current = m_tabs.current();
  if (!current) return;
  Document& document = current->document;
  document.settle();
  if (!m_window.isSettled()) return;
  QUndoStack& history = *document.history();
  const int present = history.index();
  const std::string now = contentOf(*current);
  checkFile(*current, now);
  if (!oneIn(3)) return;
  note(QStringLiteral("undoes and redoes all of %1").arg(document.name()));
  if (!goToOpened(*current)) return;
  report(*current, QStringLiteral("after all was undone"), m_opened.at(current).bytes, contentOf(*current));
  history.setIndex(present);
  report(*current, QStringLiteral("after all was redone"), now, contentOf(*current));
}

void RandomUser::report(const DocumentTab& of, const QString& when, const std::string& wanted, const std::string& is) {
  const QString changed = wanted == is ? QString() : difference(wanted, is);
  if (!changed.isEmpty())
    m_problems << QStringLiteral("%1 is not what it was, %2: %3").arg(of.document.name(), when, changed);
}

void RandomUser::checkFile(const DocumentTab& saved, const std::string& now) {
  const DocumentFile& file = saved.document.file();
  const bool isOwn = file.isContainer && !file.path.empty() && saved.written && !saved.document.isModified();
  if (!isOwn) return;
  const auto read = m_kinds.open(file.path, {}, Progress());
  if (!read) return void(m_problems << QStringLiteral("%1 cannot be opened again").arg(saved.document.name()));
  DocumentFile description;
  description.id = "random";
  description.displayUnit = read->file.displayUnit;
  const auto bytes = containerBytes(*read->kind, description, *read->content, {}, Compression::None, Progress());
  report(saved, QStringLiteral("in its file"), now, bytes ? *bytes : std::string());
}

void RandomUser::undoEverything(const std::function<void()>& alive) {
  for (int round = 0; round < 100 && answerDialogs(); ++round) QTest::qWait(20);
  while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
  const auto isSettled = [&] {
    alive();
    return m_window.isSettled();
  };
  (void)QTest::qWaitFor(isSettled, 120'000);
  for (const auto& open : m_tabs.all()) {
    m_tabs.setCurrent(open.get());
    if (goToOpened(*open))
      report(*open, QStringLiteral("after all was undone"), m_opened.at(open.get()).bytes, contentOf(*open));
  }
}

}  // namespace handwheel::test
