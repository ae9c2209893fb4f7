// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "mesh/search/PickRay.h"
#include "panels/HintBar.h"
#include "panels/StartPage.h"
#include "panels/SuggestionCard.h"
#include "tools/ToolKey.h"

#include <QAction>
#include <QKeySequence>
#include <QObject>
#include <functional>
#include <map>
#include <memory>
#include <optional>

class QMenu;
class QThreadPool;

namespace handwheel {

class DocumentTabs;
class FidelityChoice;
class HapticSession;
class JobRunner;
class LogModel;
class MachineSound;
class ServoClock;
class SpaceMouseNavigation;
class ToolHost;
class HapticSceneBuilder;
class Viewport;
class WindowServices;
struct Message;
struct DocumentTab;
struct ToolPreview;

// The parts of the window that kinds of documents may use.
struct WindowContext {
  QWidget* window;
  const DocumentKinds& kinds;
  DocumentTabs& tabs;
  JobRunner& jobs;
  QThreadPool& pool;
  LogModel& log;
  Viewport& viewport;
  WindowServices& services;
  MachineSound& sound;  // of the machine that runs, if a person wants to hear it
  ToolHost& tools;
  FidelityChoice& fidelity;
  HapticSession& haptics;
  HapticSceneBuilder& touch;
  ServoClock& servoClock;
  SpaceMouseNavigation& spaceMouse;
  QAction* saveAs;
  std::function<void(const QString& id)> chooseTool;  // of the current document
  std::function<void(const QString& path)> openFile;
  std::function<DocumentTab*(OpenedFile opened)> openDocument;  // of any kind; makes it current
  std::function<bool()> isPanelVisible;
  QAction* showPanel;
};

// The description of a tool that the user can choose.
struct ToolDescriptor {
  QString id;    // "select"
  QString text;  // "Select faces"
  QString tip;
  QString icon;
  QKeySequence key;
  std::function<std::unique_ptr<Tool>()> make;  // creates it for the current document
  std::string tool;                             // Tool::id() of the created tool
  std::span<const ToolKey> keys;                // of it
  bool isDefault = false;                       // the default tool, active while no other is chosen
};

// The descriptor of the measuring tool, which several kinds offer.
ToolDescriptor measureToolDescriptor(std::function<std::unique_ptr<Tool>()> make);

// A command that creates or opens a first document of a kind. Shown in the File menu and as a tile of the start page.
struct StartAction {
  QString id;  // of the command: "openSample"
  QString text;
  QString tip;
  QString icon;
  QString sample = {};                 // file name of a shipped sample; empty: a new document
  std::optional<StartTile> tile = {};  // none: only in the menu
  bool asks = false;                   // KindUi::begin() does it, after a question
};

// Creates the content of a document from the surface of another, as DocumentKind::ofSurface() does. The notes are what
// there is to say of it.
using MakeOfSurface = std::function<Result<SnapshotPointer>(const TriangleSoup& surface, const std::string& source,
                                                            std::vector<Note>& notes, Progress progress)>;

// The user interface of one kind of document: scene, panel, menu, tools, hints. One per window and kind.
class KindUi : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  virtual std::unique_ptr<DocumentTab> open(std::unique_ptr<Document> document) = 0;
  // To be called when a document was read from a file and all of it is reported; may add messages of the kind.
  virtual void opened(DocumentTab& document) { (void)document; }
  // Sets the current document; null when it is of another kind, or none is open. Fills the viewport or leaves it empty.
  virtual void setDocument(DocumentTab* document) = 0;
  // To be called after DocumentTab::visible was changed.
  virtual void refreshVisibility() = 0;
  // Shows what the running tool previews in place of the document, or in terms of this kind; empty when none runs. The
  // window shows the rest.
  virtual void showPreview(const ToolPreview& preview) { (void)preview; }
  // To be called before a document is destroyed.
  virtual void forget(DocumentTab* document) { (void)document; }

  // Opens a file beside the current document, such as a program that is to run on it; false: it is no such file.
  virtual bool take(const QString& path) {
    (void)path;
    return false;
  }
  // What would be lost with a document and is not in it, such as the text of a program: its name. Empty: nothing.
  virtual QString unsavedBeside(const DocumentTab& document) const {
    (void)document;
    return {};
  }
  // Saves that; ended: called with whether it is saved, which a person may have declined.
  virtual void saveBeside(DocumentTab& document, std::function<void(bool isSaved)> ended) {
    (void)document;
    ended(true);
  }

  virtual std::vector<StartAction> startActions() const { return {}; }
  // Carries out one of them that asks for something first; any document may be current, or none.
  virtual void begin(const QString& startAction) { (void)startAction; }

  // Asks how a document of this kind is to be made of the surface of another, and calls start with that, which a person
  // may decline; false: nothing is to be asked.
  virtual bool askToCopy(const Document& from, std::function<void(MakeOfSurface)> start) {
    (void)from;
    (void)start;
    return false;
  }

  // The properties of the current document, of this kind, that are in the list of its properties now.
  virtual std::vector<Property> listedProperties(const Document& document) const;
  // The menu of what is at a position of the view; null: the tool gets the click.
  virtual QMenu* menuAt(const QPointF& position) {
    (void)position;
    return nullptr;
  }

  virtual QString panelTitle() const = 0;
  virtual QString panelIcon() const = 0;  // name of an icon
  virtual QWidget* panel() = 0;           // content of the kind's dock; owned by the window
  virtual QString menuTitle() const = 0;
  virtual QList<QAction*> menu() = 0;
  virtual QList<QAction*> toolBar() = 0;
  // Actions of the help menu for such documents, available at any time.
  virtual QList<QAction*> help() { return {}; }
  // The tools for such documents. Descriptors with the same id in several kinds are the same tool to the user.
  virtual std::vector<ToolDescriptor> tools() { return {}; }

  virtual std::vector<Hint> hints() { return {}; }
  virtual Suggestion suggestion() { return {}; }
  // The axis through which the current document is cut for a half section; none: it has none.
  virtual std::optional<Ray> sectionAxis() const { return std::nullopt; }
  // Measurements of the section by the clipping plane; shown below its settings.
  virtual std::vector<Property> sectionMeasurements() const { return {}; }
  virtual QString statistics() const { return {}; }  // "1 234 triangles"
  // One line for the log when a document was opened.
  virtual QString openedText(const DocumentTab& document) const = 0;
  // The command line that produces the file from the one the document was opened from; empty when there is none.
  virtual QString saveCommand(const DocumentTab& document, const QString& path) const;
  // The file name that "Save as" proposes.
  virtual QString suggestedName(const DocumentTab& document) const;
  // True when nothing is running that will still change what is shown.
  virtual bool isSettled() const { return true; }

 signals:
  void stateChanged();  // hints, next step or statistics
  void message(const handwheel::Message& message);
};

using KindUiFactory = std::function<std::unique_ptr<KindUi>(const WindowContext&)>;

// A kind of document and the factory of its user interface.
struct KindEntry {
  std::unique_ptr<DocumentKind> kind;
  KindUiFactory window;
};

// The registered kinds of documents and the factories of their user interfaces. Factories are found by the id of the
// kind.
struct KindSet {
  // Kinds are asked in this order whether a file is theirs.
  explicit KindSet(std::vector<KindEntry> entries);

  DocumentKinds documents;
  std::map<std::string, KindUiFactory> windows;
};

}  // namespace handwheel
