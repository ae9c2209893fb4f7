// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/problems/MoveItProblem.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is a pair of YAML files: the
// scene, a form feed, the request. Without one it is both.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "MoveItProblemFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = text.find('\f');
  const auto set = readMoveItProblem(text.substr(0, end), end == text.npos ? text : text.substr(end + 1), "pair");
  if (!set) {
    require(set.error().code == ErrorCode::ElementMalformed, "another error");
    return 0;
  }
  require(set->problems.size() == 1, "not one problem");
  const PlanningProblem& problem = set->problems.front();
  require(problem.start.size() == set->joints.size() && problem.goal.size() == set->joints.size(), "too few joints");
  require(problem.names.size() == problem.obstacles.size(), "obstacles without names");
  for (const CollisionPiece& piece : problem.obstacles)
    require(piece.pose.matrix().allFinite() && piece.half.allFinite() && piece.half.minCoeff() >= 0.0, "no shape");
  return 0;
}
