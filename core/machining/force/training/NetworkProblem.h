// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/training/NetworkTraining.h"

#include <Eigen/Core>

namespace handwheel {

// The least-squares problem of training a network. It gives the error in scaled units as a function of the weights.
class NetworkProblem {
 public:
  NetworkProblem(const ForceNetwork& network, std::span<const ForceSample> samples, Progress progress);

  Eigen::Index weightCount() const { return m_weightCount; }
  bool isCancelled() const { return m_isCancelled; }  // if true, the results are invalid

  // Returns the mean squared error.
  double error(const Eigen::VectorXd& weights);
  // Returns the mean squared error, and its gradient with respect to the weights.
  double error(const Eigen::VectorXd& weights, Eigen::VectorXd& gradient);
  // Returns the mean squared error. Writes JᵀJ (lower half) to `hessian` and Jᵀe to `gradient`, each divided by the
  // number of samples.
  double error(const Eigen::VectorXd& weights, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient);

 private:
  bool stopsAt(std::size_t row);

  std::vector<ForceNetwork::Inputs> m_inputs;
  std::vector<double> m_targets;
  Eigen::Index m_weightCount;
  Eigen::VectorXd m_row;   // derivatives of one output
  Eigen::MatrixXd m_rows;  // derivatives of several outputs, one column for each
  Progress m_progress;
  bool m_isCancelled = false;
};

// The state that every trainer shares: the best weights so far and the error after each epoch.
class TrainingRecord {
 public:
  TrainingRecord(const TrainingOptions& options, Progress progress, Eigen::VectorXd weights, double error);

  // Records the end of an epoch. Returns false if training must end: at the goal, at the last epoch, or if it was
  // cancelled.
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

// The trainers. Each trainer starts from the best weights of the record and runs until the record ends or the error no
// longer falls.
void trainByLevenbergMarquardt(NetworkProblem& problem, TrainingRecord& record);
void trainByBfgs(NetworkProblem& problem, TrainingRecord& record);
void trainByScaledConjugateGradient(NetworkProblem& problem, TrainingRecord& record);
// momentum: the fraction of the previous step that is added to each step; 0: no momentum.
void trainByGradientDescent(NetworkProblem& problem, TrainingRecord& record, double momentum);

}  // namespace handwheel
