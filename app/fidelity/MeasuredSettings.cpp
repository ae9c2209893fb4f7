// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/MeasuredSettings.h"

#include "collision/ProximityFidelity.h"
#include "document/formats/step/StepFidelity.h"
#include "haptics/scene/TouchFidelity.h"
#include "haptics/snap/SnapFidelity.h"
#include "machining/TurningFidelity.h"
#include "machining/force/ForceFidelity.h"
#include "mesh/measure/MeshFidelity.h"
#include "mesh/simplify/DecimationFidelity.h"
#include "planning/PlanningFidelity.h"
#include "robot/arm/IkFidelity.h"
#include "volume/VolumeFidelity.h"

namespace handwheel {

FidelityRegistry measuredSettings() {
  FidelityRegistry registry;
  registry.add(nearWeldSetting(), nearWeldCases());
  registry.add(fillMethodSetting(), fillMethodCases());
  registry.add(fillContinuitySetting(), fillContinuityCases());
  registry.add(patchDensitySetting(), patchDensityCases());
  registry.add(pieceEdgesSetting(), pieceEdgesCases());
  registry.add(decimationErrorSetting(), decimationErrorCases());
  registry.add(decimationMethodSetting(), decimationMethodCases());
  registry.add(volumeVoxelsSetting(), volumeVoxelsCases());
  registry.add(volumeMethodSetting(), volumeMethodCases());
  registry.add(volumeReductionSetting(), volumeReductionCases());
  registry.add(volumePolygonsSetting(), volumePolygonsCases());
  registry.add(volumePiecesSetting(), volumePiecesCases());
  registry.add(drillErosionSetting(), drillErosionCases());
  registry.add(chordSetting(), chordCases());
  registry.add(stepChordSetting(), stepChordCases());
  registry.add(turnSpacingSetting(), turnSpacingCases());
  registry.add(turnMethodSetting(), turnMethodCases());
  registry.add(turnResolutionSetting(), turnResolutionCases());
  registry.add(turnStepSetting(), turnIncrementCases());
  registry.add(forceModelSetting(), forceModelCases());
  registry.add(undoGranularitySetting(), undoGranularityCases());
  registry.add(blockFacesSetting(), blockFacesCases());
  registry.add(coarseTrianglesSetting(), coarseTrianglesCases());
  registry.add(shapeSidesSetting(), shapeSidesCases());
  registry.add(ikToleranceSetting(), ikToleranceCases());
  registry.add(planResolutionSetting(), planResolutionCases());
  registry.add(planShortcutsSetting(), planShortcutsCases());
  registry.add(verifyStepSetting(), verifyStepCases());
  registry.add(proximityToleranceSetting(), proximityToleranceCases());
  registry.add(snapRadiusSetting(), snapRadiusCases());
  registry.add(snapFeaturesSetting(), snapFeaturesCases());
  registry.add(proxyToleranceSetting(), proxyToleranceCases());
  registry.add(contactStiffnessSetting(), contactStiffnessCases());
  registry.add(servoRateSetting(), servoRateCases());
  registry.add(velocityWindowSetting(), velocityWindowCases());
  return registry;
}

std::vector<FidelityCase> casesOnMesh(std::string_view id, const std::string& name, const SoupSource& soup) {
  struct Maker {
    std::string id;
    FidelityCase (*make)(const std::string&, SoupSource);
  };
  const Maker makers[] = {{nearWeldSetting().id, nearWeldCaseOn},
                          {fillMethodSetting().id, fillMethodCaseOn},
                          {fillContinuitySetting().id, fillContinuityCaseOn},
                          {patchDensitySetting().id, patchDensityCaseOn},
                          {undoGranularitySetting().id, undoGranularityCaseOn},
                          {pieceEdgesSetting().id, pieceEdgesCaseOn},
                          {decimationErrorSetting().id, decimationErrorCaseOn},
                          {blockFacesSetting().id, blockFacesCaseOn},
                          {coarseTrianglesSetting().id, coarseTrianglesCaseOn}};
  if (id == decimationMethodSetting().id) return decimationMethodCasesOn(name, soup);
  for (const Maker& maker : makers) {
    if (maker.id == id) return {maker.make(name, soup)};
  }
  return {};
}

}  // namespace handwheel
