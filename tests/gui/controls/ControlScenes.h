// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/CommandPalette.h"
#include "controls/NumberField.h"
#include "controls/PreferencesDialog.h"
#include "controls/ShortcutModel.h"
#include "controls/StatusPanel.h"
#include "controls/property/PropertyList.h"
#include "panels/DockTitle.h"
#include "panels/HintBar.h"
#include "panels/JobBar.h"
#include "panels/MessageBar.h"
#include "panels/StartPage.h"
#include "theme/Icons.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QPainter>
#include <QStatusBar>
#include <QVBoxLayout>
#include <memory>
#include <numbers>

// The controls with sample content, for tests in all sizes and themes.
namespace handwheel::test {

inline std::vector<Property> sampleProperties() {
  constexpr double kPi = std::numbers::pi;
  std::vector<Property> p;
  p.push_back({.id = "diameter",
               .group = "Stock",
               .label = "Diameter",
               .value = 50.0,
               .quantity = Quantity::Length,
               .least = 1.0,
               .largest = 500.0,
               .prefix = "⌀"});
  p.push_back({.id = "length",
               .group = "Stock",
               .label = "Length",
               .value = 120.5,
               .quantity = Quantity::Length,
               .least = 1.0,
               .largest = 2000.0});
  p.push_back({.id = "chord",
               .group = "Stock",
               .label = "Chord tolerance of the display",
               .value = 0.003,
               .quantity = Quantity::Length,
               .least = 1e-6,
               .largest = 1.0});
  p.push_back({.id = "material",
               .group = "Stock",
               .label = "Material",
               .value = 1.0,
               .choices = {"Aluminium 6082", "Steel C45", "Brass"}});
  p.push_back({.id = "coolant", .group = "Stock", .label = "Coolant is on", .value = true});
  p.push_back({.id = "note", .group = "Stock", .label = "Note", .value = std::string("first try")});
  p.push_back({.id = "joint1",
               .group = "Joints",
               .label = "shoulder_pan",
               .value = kPi / 6,
               .quantity = Quantity::Angle,
               .least = -kPi,
               .largest = kPi,
               .translated = false,
               .continuous = true});
  p.push_back({.id = "joint2",
               .group = "Joints",
               .label = "elbow",
               .value = -1.2,
               .quantity = Quantity::Angle,
               .least = -2.0,
               .largest = 0.5,
               .translated = false,
               .problem = "The effort of this joint is not known.",
               .continuous = true});
  p.push_back({.id = "volume", .group = "Facts", .label = "Triangles", .value = 1170000.0, .editable = false});
  p.push_back({.id = "size",
               .group = "Facts",
               .label = "Largest extent",
               .value = 1234.5678,
               .quantity = Quantity::Length,
               .editable = false});
  p.push_back({.id = "closed", .group = "Facts", .label = "Closed", .value = false, .editable = false});
  return p;
}

inline QAction* addAction(QMenu* menu, const char* name, const QString& text, const QKeySequence& key,
                          const char* iconName = nullptr, const QString& toolTip = {}) {
  QAction* action = menu->addAction(text);
  action->setObjectName(QString::fromLatin1(name));
  action->setShortcut(key);
  if (iconName) action->setIcon(icon(QString::fromLatin1(iconName)));
  if (!toolTip.isEmpty()) action->setToolTip(toolTip);
  return action;
}

// Returns a window with some menus.
inline std::unique_ptr<QMainWindow> sampleWindow() {
  auto window = std::make_unique<QMainWindow>();
  QMenu* file = window->menuBar()->addMenu("&File");
  addAction(file, "openFile", "&Open…", QKeySequence("Ctrl+O"), "open", "Open a mesh, a workpiece or a cell");
  addAction(file, "save", "&Save", QKeySequence("Ctrl+S"), "save", "There is nothing to save")->setEnabled(false);
  addAction(file, "saveAs", "Save &as…", QKeySequence("Ctrl+Shift+S"), "save-as");
  QMenu* edit = window->menuBar()->addMenu("&Edit");
  addAction(edit, "undo", "&Undo", QKeySequence("Ctrl+Z"), "undo");
  QAction* redo = addAction(edit, "redo", "&Redo", {}, "redo");
  redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  QMenu* shading = window->menuBar()->addMenu("&View")->addMenu("&Shading");
  addAction(shading, "shaded", "&Shaded", QKeySequence("S"), "shaded");
  addAction(shading, "shadedWithEdges", "Shaded with &edges", {}, "shaded-edges");
  addAction(shading, "wireframe", "&Wireframe", {}, "wireframe")->setCheckable(true);
  window->setCentralWidget(new QWidget(window.get()));
  return window;
}

inline QPixmap samplePicture(const QString& path) {
  if (!path.endsWith("stl")) return {};
  QPixmap picture(320, 200);
  picture.fill(QColor(0x5b6b80));
  QPainter painter(&picture);
  painter.setBrush(QColor(0xd8dee8));
  painter.drawEllipse(QPoint(160, 100), 70, 60);
  return picture;
}

inline std::unique_ptr<StartPage> sampleStartPage() {
  auto page = std::make_unique<StartPage>();
  page->setTiles({{"sampleTile", "repair", "Repair a sample scan",
                   "Opens a sample scan with holes. Press Enter to close the first one."},
                  {"latheTile", "kind-workpiece", "Turn a sample bar", "Opens a sample bar.", false},
                  {"cellTile", "kind-cell", "Robot cell",
                   "Opens a sample arm with six joints. Drag its links within their limits."}});
  page->setPictures(samplePicture, [](const QString&) { return QStringLiteral("kind-mesh"); });
  page->setRecentFiles({"/home/a/scans/bunny.stl", "/home/a/a-very-long-name-of-a-scan-from-tuesday-afternoon-2.stl",
                        "/home/a/robots/ur5.urdf", "/home/a/parts/shaft.step", "/home/a/cells/welding.handwheel",
                        "/home/a/readme.txt"});
  return page;
}

inline std::vector<ServiceStatus> sampleServices() {
  return {{"contact", "Surface contact", true, 1000.0, 41.7, ServiceStatus::Budget::ServoTick, 0.042},
          {"display", "Display", true, 58.4, 9120.0, ServiceStatus::Budget::Frame, 0.82},
          {"clay", "Voxel erosion", false, 0.0, 0.0, ServiceStatus::Budget::ServoTick, 0.0},
          {"autosave", "Autosave", true, 0.03, 15.0, ServiceStatus::Budget::None, 0.0}};
}

inline std::vector<Hint> sampleHints() {
  return {{"Middle drag", "orbit"},
          {"Wheel", "zoom"},
          {"Click", "select a hole"},
          {"Enter", "fill it", false},
          {"Esc", "leave"}};
}

inline std::vector<NavigationChoice> sampleNavigation() {
  return {{"handwheel", "Handwheel", "Middle: orbit, Shift+middle: pan, wheel: zoom to the cursor"},
          {"blender", "Blender", "Middle: orbit, Shift+middle: pan, Ctrl+middle: zoom"}};
}

}  // namespace handwheel::test
