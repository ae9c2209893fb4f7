// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/training/NetworkProblem.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr Eigen::Index kJacobianBlock = 64;    // rows of the Jacobian at once
constexpr std::size_t kLookForCancel = 1'024;  // rows between two checks

std::span<const double> spanOf(const Eigen::VectorXd& weights) {
  return {weights.data(), static_cast<std::size_t>(weights.size())};
}

}  // namespace

NetworkProblem::NetworkProblem(const ForceNetwork& network, std::span<const ForceSample> samples, Progress progress)
    : m_weightCount(static_cast<Eigen::Index>(network.weights.size())),
      m_row(m_weightCount),
      m_rows(m_weightCount, kJacobianBlock),
      m_progress(progress) {
  for (const ForceSample& sample : samples) {
    m_inputs.push_back(network.scaled(sample.cut));
    m_targets.push_back(network.scaledForce(sample.force));
  }
}

bool NetworkProblem::stopsAt(std::size_t row) {
  if (row % kLookForCancel == 0 && m_progress.cancelled()) m_isCancelled = true;
  return m_isCancelled;
}

double NetworkProblem::error(const Eigen::VectorXd& weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < m_inputs.size() && !stopsAt(i); ++i) {
    const double e = networkOutput(spanOf(weights), m_inputs[i]) - m_targets[i];
    sum += e * e;
  }
  return sum / static_cast<double>(m_inputs.size());
}

double NetworkProblem::error(const Eigen::VectorXd& weights, Eigen::VectorXd& gradient) {
  double sum = 0.0;
  gradient.setZero(m_weightCount);
  for (std::size_t i = 0; i < m_inputs.size() && !stopsAt(i); ++i) {
    const double e = networkOutput(spanOf(weights), m_inputs[i], m_row.data()) - m_targets[i];
    sum += e * e;
    gradient += (2.0 * e) * m_row;
  }
  const auto n = static_cast<double>(m_inputs.size());
  gradient /= n;
  return sum / n;
}

double NetworkProblem::error(const Eigen::VectorXd& weights, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) {
  double sum = 0.0;
  hessian.setZero(m_weightCount, m_weightCount);
  gradient.setZero(m_weightCount);
  Eigen::Index filled = 0;
  const auto add = [&] {
    hessian.selfadjointView<Eigen::Lower>().rankUpdate(m_rows.leftCols(filled));
    filled = 0;
  };
  for (std::size_t i = 0; i < m_inputs.size() && !stopsAt(i); ++i) {
    auto row = m_rows.col(filled++);
    const double e = networkOutput(spanOf(weights), m_inputs[i], row.data()) - m_targets[i];
    sum += e * e;
    gradient += e * row;
    if (filled == kJacobianBlock) add();
  }
  if (filled > 0) add();
  const auto n = static_cast<double>(m_inputs.size());
  hessian /= n;
  gradient /= n;
  return sum / n;
}

TrainingRecord::TrainingRecord(const TrainingOptions& options, Progress progress, Eigen::VectorXd weights, double error)
    : m_goal(options.goal),
      m_most(options.epochs > 0 ? options.epochs : mostEpochs(options.trainer)),
      m_progress(progress),
      m_weights(std::move(weights)),
      m_best(error),
      m_errors{error} {}

bool TrainingRecord::add(const Eigen::VectorXd& weights, double error) {
  m_errors.push_back(error);
  m_progress.set(static_cast<double>(m_errors.size() - 1) / static_cast<double>(m_most));
  if (error < m_best) {
    m_best = error;
    m_weights = weights;
  }
  return !hasEnded() && !m_progress.cancelled();
}

}  // namespace handwheel
