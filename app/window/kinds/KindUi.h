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
  MachineSound& sound;  // Sound of the running machine, if sound is enabled
  ToolHost& tools;
  FidelityChoice& fidelity;
  HapticSession& haptics;
  HapticSceneBuilder& touch;
  ServoClock& servoClock;
  SpaceMouseNavigation& spaceMouse;
  QAction* saveAs;
  std::function<void(const QString& id)> chooseTool;  // Chooses a tool of the current document
  std::function<void(const QString& path)> openFile;
  std::function<DocumentTab*(OpenedFile opened)> openDocument;  // Opens a document of any kind and makes it current
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
  std::function<std::unique_ptr<Tool>()> make;  // Creates the tool for the current document
  std::string tool;                             // Tool::id() of the created tool
  std::span<const ToolKey> keys;                // Keys of the tool
  bool isDefault = false;                       // The default tool, active while no other is chosen
};

// Returns the descriptor of the measuring tool, which several kinds offer.
ToolDescriptor measureToolDescriptor(std::function<std::unique_ptr<Tool>()> make);

// A command that creates or opens a first document of a kind. It is shown in the File menu and as a tile of the start
// page.
struct StartAction {
  QString id;  // Id of the command: "openSample"
  QString text;
  QString tip;
  QString icon;
  QString sample = {};                 // File name of a shipped sample; empty: a new document
  std::optional<StartTile> tile = {};  // Nothing: the command is only in the menu
  bool asks = false;                   // True if KindUi::begin() executes the command, after a question
};

// Creates the content of a document from the surface of another, as DocumentKind::ofSurface() does. notes: remarks
// about the result.
using MakeOfSurface = std::function<Result<SnapshotPointer>(const TriangleSoup& surface, const std::string& source,
                                                            std::vector<Note>& notes, Progress progress)>;

// The user interface of one kind of document: scene, panel, menu, tools, hints. Each window has one for each kind.
class KindUi : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  virtual std::unique_ptr<DocumentTab> open(std::unique_ptr<Document> document) = 0;
  // Adds messages of the kind about an opened document. Must be called after the document was read from a file and
  // the window has reported the losses.
  virtual void opened(DocumentTab& document) { (void)document; }
  // Sets the current document; null if it is of another kind, or none is open. The function fills the viewport, or
  // leaves it empty.
  virtual void setDocument(DocumentTab* document) = 0;
  // Updates the display. Must be called after DocumentTab::visible was changed.
  virtual void refreshVisibility() = 0;
  // Shows the parts of a preview that replace the document or are specific to this kind. The window shows the rest.
  // preview: the preview of the running tool; empty if no tool is running.
  virtual void showPreview(const ToolPreview& preview) { (void)preview; }
  // Removes all references to a document. Must be called before the document is destroyed.
  virtual void forget(DocumentTab* document) { (void)document; }

  // Opens a file beside the current document, such as a program that runs on it. Returns false if the file is not of
  // this kind.
  virtual bool take(const QString& path) {
    (void)path;
    return false;
  }
  // Returns the name of the unsaved data beside a document, such as the text of a program; empty if there are none.
  virtual QString unsavedBeside(const DocumentTab& document) const {
    (void)document;
    return {};
  }
  // Saves the unsaved data beside a document. ended: receives true if they are saved, false if the user declined.
  virtual void saveBeside(DocumentTab& document, std::function<void(bool isSaved)> ended) {
    (void)document;
    ended(true);
  }

  virtual std::vector<StartAction> startActions() const { return {}; }
  // Executes a start action that begins with a question. Any document may be current, or none.
  virtual void begin(const QString& startAction) { (void)startAction; }

  // Asks for the options of creating a document of this kind from the surface of another one, and calls start with them
  // unless the user declines. Returns false if there are no options.
  virtual bool askToCopy(const Document& from, std::function<void(MakeOfSurface)> start) {
    (void)from;
    (void)start;
    return false;
  }

  // Returns the properties of the current document that the list of properties shows at present. document: the current
  // document, which must be of this kind.
  virtual std::vector<Property> listedProperties(const Document& document) const;
  // Returns the context menu for the object at a position of the view; null if there is none and the tool gets the
  // click.
  virtual QMenu* menuAt(const QPointF& position) {
    (void)position;
    return nullptr;
  }

  virtual QString panelTitle() const = 0;
  virtual QString panelIcon() const = 0;  // Name of an icon
  virtual QWidget* panel() = 0;           // Content of the kind's dock; owned by the window
  virtual QString menuTitle() const = 0;
  virtual QList<QAction*> menu() = 0;
  virtual QList<QAction*> toolBar() = 0;
  // Returns the actions of the help menu for documents of this kind. They are available at any time.
  virtual QList<QAction*> help() { return {}; }
  // Returns the tools for documents of this kind. Descriptors with the same id in several kinds are the same tool to
  // the user.
  virtual std::vector<ToolDescriptor> tools() { return {}; }

  virtual std::vector<Hint> hints() { return {}; }
  virtual Suggestion suggestion() { return {}; }
  // Returns the axis through which the current document is cut for a half section; nothing if the document has no axis.
  virtual std::optional<Ray> sectionAxis() const { return std::nullopt; }
  // Returns the measurements of the section at the clipping plane, which are shown below the settings of the plane.
  virtual std::vector<Property> sectionMeasurements() const { return {}; }
  virtual QString statistics() const { return {}; }  // "1 234 triangles"
  // Returns one line for the log about a document that was opened.
  virtual QString openedText(const DocumentTab& document) const = 0;
  // Returns the command line that produces the file from the one that the document was opened from; empty if there is
  // no such command.
  virtual QString saveCommand(const DocumentTab& document, const QString& path) const;
  // Returns the file name that "Save as" proposes.
  virtual QString suggestedName(const DocumentTab& document) const;
  // Returns true if nothing is running that will change the display.
  virtual bool isSettled() const { return true; }

 signals:
  void stateChanged();  // Emitted when hints, next step or statistics have changed
  void message(const handwheel::Message& message);
};

using KindUiFactory = std::function<std::unique_ptr<KindUi>(const WindowContext&)>;

// A kind of document and the factory of its user interface.
struct KindEntry {
  std::unique_ptr<DocumentKind> kind;
  KindUiFactory window;
};

// The registered kinds of documents and the factories of their user interfaces. The factories are stored by the ids of
// the kinds.
struct KindSet {
  // entries: the kinds in the order in which they are asked to recognise a file.
  explicit KindSet(std::vector<KindEntry> entries);

  DocumentKinds documents;
  std::map<std::string, KindUiFactory> windows;
};

}  // namespace handwheel
