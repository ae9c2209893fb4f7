// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/mesh/FillHoleTool.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/voxels/MeshDrillTool.h"
#include "window/JobRunner.h"

namespace handwheel {

class BoundaryTool;
class HolePreview;
class MeshLayer;
class RepairActions;
class RepairJobs;
class LoopSelection;
class ToolHost;
struct MeshTab;

// Creates the mesh tools and connects them to the window. It provides the tools with jobs and picking on the document,
// and synchronises the hole of the tool with the hole that is selected in the list.
class MeshTools : public QObject {
  Q_OBJECT

 public:
  MeshTools(QWidget* window, ToolHost& host, QThreadPool& pool, const MeshLayer& layer, LoopSelection& selection,
            HolePreview& preview, RepairActions& actions, RepairJobs& jobs, QObject* parent = nullptr);

  void setDocument(MeshTab* document);
  // Sets the method for holes that are filled one by one.
  void chooseMethod(FillMethod method);
  // Hides the patch of the hole while the preview of another method of closing the hole is shown.
  void setPatchHidden(bool isHidden);
  // Shows the fill options after a change that the tool did not make.
  void showChoice();

  std::unique_ptr<Tool> fillTool();
  std::unique_ptr<Tool> selectTool();
  std::unique_ptr<Tool> boundaryTool();
  std::unique_ptr<Tool> makeFaceTool();
  // Creates the sculpting tool for the selected faces, or else for those that the last edit added.
  std::unique_ptr<Tool> sculptTool();
  std::unique_ptr<Tool> measureTool();
  std::unique_ptr<Tool> decimateTool();
  std::unique_ptr<Tool> subdivideTool();
  std::unique_ptr<Tool> transformTool();
  std::unique_ptr<Tool> volumeRepairTool();
  std::unique_ptr<Tool> drillTool(const SimulationServices& simulation, MeshDrillTool::OfferVolume offer);

 private:
  const FillHoleTool* runningFillTool() const;
  const BoundaryTool* runningBoundaryTool() const;
  void request(const FillRequest& request);
  void answer();
  void followSelection();
  void followTool();
  MeshServices services();

  QWidget* m_window;  // parent of message boxes
  ToolHost& m_host;
  const MeshLayer& m_layer;
  LoopSelection& m_selection;
  HolePreview& m_preview;
  RepairActions& m_actions;
  RepairJobs& m_jobs;
  JobRunner m_thinking;  // runs the jobs of the select tool
  MeshTab* m_document = nullptr;
  std::uint64_t m_ticket = 0;
  bool m_isPatchHidden = false;
};

}  // namespace handwheel
