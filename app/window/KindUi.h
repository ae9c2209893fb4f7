// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "panels/HintBar.h"
#include "panels/NextStepCard.h"
#include "panels/StartPage.h"
#include "tools/ToolKey.h"

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <functional>
#include <map>
#include <memory>

class QThreadPool;

namespace handwheel {

class DocumentTabs;
class FidelityChoice;
class HapticSession;
class JobRunner;
class LogModel;
class ToolHost;
class TouchScene;
class Viewport;
class WindowServices;
struct Message;
struct OpenDocument;

// What the parts of the window offer to the kinds of documents.
struct WindowParts {
  QWidget* window;
  const DocumentKinds& kinds;
  DocumentTabs& tabs;
  JobRunner& jobs;
  QThreadPool& pool;
  LogModel& log;
  Viewport& viewport;
  WindowServices& services;
  ToolHost& tools;
  FidelityChoice& fidelity;
  HapticSession& haptics;
  TouchScene& touch;
  QAction* saveAs;
  std::function<void(const QString& path)> openFile;
  std::function<bool()> isPanelVisible;
  QAction* showPanel;
};

// A tool that can be chosen.
struct ToolOffer {
  QString id;    // "select"
  QString text;  // "Select faces"
  QString tip;
  QString icon;
  QKeySequence key;
  std::function<std::unique_ptr<Tool>()> make;  // for the document in view
  std::string tool;                             // Tool::id() of what is made
  std::span<const ToolKey> keys;                // of it
  bool isUsual = false;                         // in use as long as no other is chosen
};

// The ruler, which several kinds offer.
ToolOffer measureOffer(std::function<std::unique_ptr<Tool>()> make);

// A way to begin with a document of the kind: a command of the File menu, and a tile of the start page.
struct Beginning {
  QString id;  // of the command: "openSample"
  QString text;
  QString tip;
  QString icon;
  QString sample = {};                 // the file, of those that are shipped; empty: a new document
  std::optional<StartTile> tile = {};  // none: it is in the menu only
};

// What the window adds for one kind of document: its scene, panel, menu, tools and advice. One per window and kind.
class KindUi : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  virtual std::unique_ptr<OpenDocument> open(std::unique_ptr<Document> document) = 0;
  // The document in view; null when it is of another kind, or none is open. Fills the viewport or leaves it empty.
  virtual void setDocument(OpenDocument* document) = 0;
  // After OpenDocument::visible was changed.
  virtual void refreshVisibility() = 0;
  // Before a document goes.
  virtual void forget(OpenDocument* document) { (void)document; }

  virtual std::vector<Beginning> beginnings() const { return {}; }

  virtual QString panelTitle() const = 0;
  virtual QString panelIcon() const = 0;  // name of a drawing
  virtual QWidget* panel() = 0;           // of the dock of the kind; owned by the window
  virtual QString menuTitle() const = 0;
  virtual QList<QAction*> menu() = 0;
  virtual QList<QAction*> toolBar() = 0;
  // What shows how to work on such documents, at any time.
  virtual QList<QAction*> help() { return {}; }
  // The tools for such documents. Offers with the same id in several kinds are the same tool to the user.
  virtual std::vector<ToolOffer> tools() { return {}; }

  virtual std::vector<Hint> hints() { return {}; }
  virtual NextStep nextStep() { return {}; }
  // Of the cut by the clipping plane; shown below its settings.
  virtual std::vector<Property> sectionFigures() const { return {}; }
  virtual QString figures() const { return {}; }  // "1 234 triangles"
  // One line for the log when a document was opened.
  virtual QString openedText(const OpenDocument& document) const = 0;
  // The command line that makes the file of the one that the document came from; empty when none does.
  virtual QString saveCommand(const OpenDocument& document, const QString& path) const;
  // The name that "Save as" offers.
  virtual QString suggestedName(const OpenDocument& document) const;
  // Nothing runs that will still change what is shown.
  virtual bool isSettled() const { return true; }

 signals:
  void stateChanged();  // hints, next step or figures
  void message(const handwheel::Message& message);
};

using KindUiFactory = std::function<std::unique_ptr<KindUi>(const WindowParts&)>;

// A kind of document and its part of the window.
struct KindEntry {
  std::unique_ptr<DocumentKind> kind;
  KindUiFactory window;
};

// The kinds of documents as the program registers them, and what the window adds to each, by the id of the kind.
struct KindSet {
  // Asked in this order whose a file is.
  explicit KindSet(std::vector<KindEntry> entries);

  DocumentKinds documents;
  std::map<std::string, KindUiFactory> windows;
};

}  // namespace handwheel
