// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "window/kinds/KindUi.h"
#include "window/mesh/deviation/DeviationPanel.h"

#include <QAction>
#include <QPointer>
#include <map>

namespace handwheel {

class MeshLayer;
struct MeshDeviation;
struct MeshTab;
struct Pick;

// Compares the current mesh with its original state or with another file. The distances are shown as colours on the
// surface, as statistics in a panel, and under the pointer. They are removed when the mesh changes.
class DeviationView : public QObject {
  Q_OBJECT

 public:
  DeviationView(const WindowContext& parts, MeshLayer& layer, QObject* parent = nullptr);

  QAction* action() { return &m_action; }
  DeviationPanel* panel() { return m_panel; }

  void setDocument(MeshTab* document);
  // Returns true if a comparison of the current document is shown or running.
  bool isShown() const;

 signals:
  void shownChanged();
  void message(const handwheel::Message& message);

 private:
  enum class Round { First, Second };
  // Compares a mesh. path: the file to compare with; empty: the mesh as it was opened.
  void compare(MeshTab* document, const QString& path, Round round);
  void take(MeshTab* document, std::shared_ptr<MeshDeviation> found, Round round);
  void fail(MeshTab* document, std::uint64_t request, const Error& error);
  void stop(const DocumentTab* document);
  // Returns true if this comparison of the document runs; request: its number, 0: any.
  bool isRunning(const DocumentTab* document, std::uint64_t request = 0) const;
  void close();
  void refresh();
  void askForFile();
  void askForReport();
  void saveReport(const QString& path);
  void reportSaved(const QString& path, const std::optional<Error>& problem);
  void flyTo(const DeviationExtremum& extremum);
  void read(const Pick& pick);

  WindowContext m_parts;
  MeshLayer& m_layer;
  QAction m_action;
  QPointer<DeviationPanel> m_panel;
  MeshTab* m_document = nullptr;
  std::map<const DocumentTab*, std::uint64_t> m_running;  // number of the running comparison of each document
  std::uint64_t m_requests = 0;
};

}  // namespace handwheel
