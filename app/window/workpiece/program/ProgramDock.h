// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

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
// shows its content while the dock is open. Window thread.
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

  // Opens a program in the dock; false: the file name is not that of a program.
  bool take(const QString& path);
  // Returns the name of the program whose text would be lost with a document; empty: none.
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
  bool m_isOpen = false;     // set by the user, for all workpieces
  bool m_isInFront = false;  // in front of the panels that are tabbed with it
  QPointer<QDockWidget> m_dock;
  QPointer<QStackedWidget> m_pages;
  QPointer<SimulationBanner> m_banner;
  std::shared_ptr<PathLayer> m_layer, m_zeroLayer;
  std::pair<double, double> m_zero;  // mm: z of the drawn zero, and its size; 0: none is drawn
  bool m_isVisible = true;           // visibility of the document
  std::map<const DocumentTab*, std::unique_ptr<ProgramSession>> m_sessions;
  DocumentTab* m_document = nullptr;
};

}  // namespace handwheel
