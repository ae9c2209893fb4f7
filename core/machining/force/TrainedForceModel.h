// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/ForceNetwork.h"

#include <string>

namespace handwheel {

// A trained network as a law of cutting forces, with its origin.
//
// A network is meaningless beyond its data. Outside the range of its training set the force follows the power law
// fitted to the same set, and covers() is false. In a margin around the range, kRim times as wide as the range, the
// network blends into the power law, so that the hand feels no step.
class TrainedForceModel : public CuttingForceModel {
 public:
  static constexpr double kRim = 0.05;

  struct Origin {
    std::string data;         // the source of the training rows, as a sentence
    bool isSynthetic = true;  // the rows were calculated, not measured
    std::string material;     // id of a work material; empty: not known
    std::string trainer;      // word of the trainer
    std::uint64_t seed = 0, epochs = 0, cuts = 0;
    double error = 0.0;         // mean squared error in scaled units
    double heldOutError = 0.0;  // mean relative error of the force on held-out cuts; 0: not measured
    bool operator==(const Origin&) const = default;
  };

  // The edge determines the feed force and the radial force, because a network gives the cutting force only.
  TrainedForceModel(ForceNetwork network, const PowerLaw& powerLaw, Origin origin, const CuttingEdge& edge = {},
                    const ThrustSettings& thrust = {});

  CutForces at(const CutConditions& cut) const noexcept override;
  bool covers(const CutConditions& cut) const noexcept override;  // true within the range of the training set

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
// Reads a model from untrusted JSON. Errors: FileTooLarge {bytes}, HeaderMalformed, VersionNewer, ElementMalformed,
// CountMismatch {weights}, ValueOutOfRange.
Result<TrainedForceModel> forceModelFromJson(std::string_view text, const CuttingEdge& edge = {},
                                             const ThrustSettings& thrust = {});
inline constexpr std::size_t kMostModelBytes = 1'000'000;

// Returns the shipped model, trained on rows that were calculated from the cited tables.
TrainedForceModel shippedForceModel(const CuttingEdge& edge = {}, const ThrustSettings& thrust = {});

}  // namespace handwheel
