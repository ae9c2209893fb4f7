// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "window/kinds/KindUi.h"

#include <QAction>
#include <QPointer>
#include <functional>
#include <map>
#include <memory>

class QDockWidget;
class QStackedWidget;

namespace handwheel {

class PathLayer;
class ProgramSession;
class SimulationBanner;
struct DisplayModel;

// The dock “Program” of workpieces, with a page for each document. A page is made when it is first shown; the view
// shows its content while the dock is open. It must be used on the window thread.
class ProgramDock : public QObject {
  Q_OBJECT

 public:
  ProgramDock(const WindowContext& parts, QObject* parent);
  ~ProgramDock() override;

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);
  void forget(DocumentTab* document);
  void setVisible(bool isVisible);  // visibility of the document, and so of its program in the view
  bool isSettled() const;

  // Opens a program in the dock. Returns false if the file name is not that of a program.
  bool take(const QString& path);
  // Returns the name of the program whose text would be lost with a document. The name is empty if there is no such
  // program.
  QString unsavedOf(const DocumentTab& document) const;
  void saveOf(const DocumentTab& document, std::function<void(bool isSaved)> ended);

 signals:
  // Emits a part that the view shows instead of the document; null: the document.
  void partShown(const std::shared_ptr<const handwheel::DisplayModel>& part);
  void message(const handwheel::Message& message);

 private:
  void makeDock();
  void open(bool isOpen);
  void follow();
  ProgramSession* present();
  void show();
  void showBanner(const ProgramSession* session);
  void showZero(bool isShown);

  WindowContext m_parts;
  QAction m_toggle;
  bool m_isOpen = false;     // true: the user has opened the dock, for all workpieces
  bool m_isInFront = false;  // true: the dock is in front of the panels that are tabbed with it
  QPointer<QDockWidget> m_dock;
  QPointer<QStackedWidget> m_pages;
  QPointer<SimulationBanner> m_banner;
  std::shared_ptr<PathLayer> m_layer, m_zeroLayer;
  std::pair<double, double> m_zero;  // mm: z and size of the drawn zero; size 0: no zero is drawn
  bool m_isFromBehind = false;       // the text of the zero is for a camera behind the part
  bool m_isVisible = true;           // visibility of the document
  std::map<const DocumentTab*, std::unique_ptr<ProgramSession>> m_sessions;
  DocumentTab* m_document = nullptr;
};

}  // namespace handwheel
