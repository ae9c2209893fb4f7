// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/training/NetworkTraining.h"

#include <Eigen/Core>

namespace handwheel {

// The least-squares problem of training a network. It gives the error as a function of the weights, in scaled units.
class NetworkProblem {
 public:
  NetworkProblem(const ForceNetwork& network, std::span<const ForceSample> samples, Progress progress);

  Eigen::Index weightCount() const { return m_weightCount; }
  bool isCancelled() const { return m_isCancelled; }  // true: results are invalid

  // Returns the mean squared error.
  double error(const Eigen::VectorXd& weights);
  // The same with its gradient.
  double error(const Eigen::VectorXd& weights, Eigen::VectorXd& gradient);
  // The same with JᵀJ (lower half) and Jᵀe, both divided by the number of samples.
  double error(const Eigen::VectorXd& weights, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient);

 private:
  bool stopsAt(std::size_t row);

  std::vector<ForceNetwork::Inputs> m_inputs;
  std::vector<double> m_targets;
  Eigen::Index m_weightCount;
  Eigen::VectorXd m_row;   // derivatives of one output
  Eigen::MatrixXd m_rows;  // derivatives of several outputs, one to a column
  Progress m_progress;
  bool m_isCancelled = false;
};

// The state that every trainer shares: the best weights so far and the error after each epoch.
class TrainingRecord {
 public:
  TrainingRecord(const TrainingOptions& options, Progress progress, Eigen::VectorXd weights, double error);

  // Records the end of an epoch. Returns false at the goal, at the last epoch, or if it was cancelled: training ends.
  bool add(const Eigen::VectorXd& weights, double error);

  bool isAtGoal() const { return m_best <= m_goal; }
  const Eigen::VectorXd& best() const { return m_weights; }
  const std::vector<double>& errors() const { return m_errors; }
  bool hasEnded() const { return isAtGoal() || m_errors.size() > m_most; }

 private:
  double m_goal;
  std::size_t m_most;
  Progress m_progress;
  Eigen::VectorXd m_weights;
  double m_best;
  std::vector<double> m_errors;
};

// The trainers. Each continues from the best weights of the record until it ends or makes no more progress.
void trainByLevenbergMarquardt(NetworkProblem& problem, TrainingRecord& record);
void trainByBfgs(NetworkProblem& problem, TrainingRecord& record);
void trainByScaledConjugateGradient(NetworkProblem& problem, TrainingRecord& record);
// momentum: the share of the previous step that is added to each step; 0: none.
void trainByGradientDescent(NetworkProblem& problem, TrainingRecord& record, double momentum);

}  // namespace handwheel
