// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/ForceNetwork.h"

#include <string>

namespace handwheel {

// A trained network as a law of cutting forces, with what it was trained on.
//
// A network says nothing beyond its data: outside the range of its training set the force is that of the power law
// fitted to the same set, and covers() is false. From the border on, over kRim of the range, the one goes over into the
// other, so that the hand feels no step.
class TrainedForceModel : public CuttingForceModel {
 public:
  static constexpr double kRim = 0.05;

  struct Origin {
    std::string data;         // a sentence: the rows that it was trained on
    bool isSynthetic = true;  // they were calculated, and not measured
    std::string material;     // id of a work material; empty where it is not known
    std::string trainer;      // its word
    std::uint64_t seed = 0, epochs = 0, cuts = 0;
    double error = 0.0;         // mean squared, in scaled units
    double heldOutError = 0.0;  // mean share of the force, of cuts that it was not trained on; 0: not measured
    bool operator==(const Origin&) const = default;
  };

  // The edge is for feed and radial force: a network knows the cutting force only.
  TrainedForceModel(ForceNetwork network, const PowerLaw& powerLaw, Origin origin, const CuttingEdge& edge = {},
                    const ThrustSettings& thrust = {});

  CutForces at(const CutConditions& cut) const noexcept override;
  bool covers(const CutConditions& cut) const noexcept override;  // within the range of the training set

  const ForceNetwork& network() const { return m_network; }
  const PowerLaw& powerLaw() const { return m_powerLaw; }
  const Origin& origin() const { return m_origin; }

 private:
  ForceNetwork m_network;
  PowerLaw m_powerLaw;
  Origin m_origin;
  CuttingEdge m_edge;
  ThrustSettings m_thrust;
};

// Writes a model as JSON.
std::string toJson(const TrainedForceModel& model);
// Reads it, from untrusted text. Errors: FileTooLarge {bytes}, HeaderMalformed, VersionNewer, ElementMalformed,
// CountMismatch {weights}, ValueOutOfRange.
Result<TrainedForceModel> forceModelFromJson(std::string_view text, const CuttingEdge& edge = {},
                                             const ThrustSettings& thrust = {});
inline constexpr std::size_t kMostModelBytes = 1'000'000;

// The model that the program ships, trained on rows that were calculated from the cited tables.
TrainedForceModel shippedForceModel(const CuttingEdge& edge = {}, const ThrustSettings& thrust = {});

}  // namespace handwheel
