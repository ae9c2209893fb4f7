// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleSequence.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace handwheel {
namespace {

using Clock = std::chrono::steady_clock;

enum class Task { Keep, Flatten, Propose };  // in the order in which the loops are gone through

class HoleSequence {
 public:
  HoleSequence(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options)
      : m_input(mesh), m_mesh(mesh), m_loops(loops), m_options(options), m_fills(loops.size()) {}

  // The tasks: one for each loop.
  void run(const std::vector<Task>& tasks, Progress progress) {
    std::vector<std::size_t> order(m_loops.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(tasks[a], m_loops[a].halfEdges.size()) < std::pair(tasks[b], m_loops[b].halfEdges.size());
    });
    HoleFiller filler(m_input, progress.part(0.0, 0.1).unlimited());
    const Progress filling = progress.part(0.1, 1.0);
    for (std::size_t k = 0; k < order.size() && !filling.unlimited().cancelled(); ++k) {
      const std::size_t i = order[k];
      fill(filler, i, tasks[i], filling.part(double(k) / double(order.size()), double(k + 1) / double(order.size())));
    }
    m_mesh = filler.mesh();
  }

  // Returns the tasks of a second run; none if no bulging patch is near a loop that others obstruct.
  std::vector<Task> secondThoughts() const {
    std::vector<Task> tasks(m_loops.size(), Task::Keep);
    bool any = false;
    for (std::size_t blocked = 0; blocked < m_loops.size(); ++blocked) {
      const FillFailure failure = m_fills[blocked].attempt.failure;
      if (failure != FillFailure::SelfIntersecting && failure != FillFailure::NarrowTriangles) continue;
      tasks[blocked] = Task::Propose;
      for (std::size_t i = 0; i < m_loops.size(); ++i) {
        if (!bulges(i) || !boxOf(i).intersects(m_loops[blocked].box)) continue;
        tasks[i] = Task::Flatten;
        any = true;
      }
    }
    return any ? tasks : std::vector<Task>{};
  }

  std::size_t openCount() const {
    return static_cast<std::size_t>(std::count_if(m_fills.begin(), m_fills.end(), [](const HoleFill& fill) {
      return fill.attempt.failure != FillFailure::None;
    }));
  }

  const HalfEdgeMesh& mesh() const { return m_mesh; }
  std::vector<HoleFill> takeFills() { return std::move(m_fills); }

 private:
  void fill(HoleFiller& filler, std::size_t i, Task task, Progress progress) {
    const auto start = Clock::now();
    HoleFill& fill = m_fills[i];
    if (task != Task::Keep) {
      FillOptions options = m_options;
      if (task == Task::Flatten) options.method = FillMethod::Refined;
      fill.attempt = filler.propose(m_loops[i], options, progress);
      const bool isSpent = fill.attempt.failure == FillFailure::Cancelled && !progress.unlimited().cancelled();
      if (isSpent) fill.attempt.failure = FillFailure::TooMuchEffort;
    }
    if (fill.attempt.failure == FillFailure::None) filler.accept(m_loops[i], fill.attempt.patch);
    fill.milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    progress.set(1.0);
  }

  bool bulges(std::size_t i) const {
    const FillAttempt& attempt = m_fills[i].attempt;
    return attempt.failure == FillFailure::None &&
           (attempt.patch.method == FillMethod::Fair || attempt.patch.method == FillMethod::Crease);
  }

  Box boxOf(std::size_t i) const {
    Box box = m_loops[i].box;
    for (const Vec3& p : m_fills[i].attempt.patch.points) box.extend(p);
    return box;
  }

  const HalfEdgeMesh m_input;
  HalfEdgeMesh m_mesh;
  std::span<const BoundaryLoop> m_loops;
  const FillOptions& m_options;
  std::vector<HoleFill> m_fills;
};

}  // namespace

std::vector<HoleFill> fillHoles(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                                Progress progress) {
  if (loops.empty()) return {};
  HoleSequence filling(mesh, loops, options);
  filling.run(std::vector(loops.size(), Task::Propose), progress.part(0.0, 0.7));
  const std::vector<Task> tasks = filling.secondThoughts();
  if (!tasks.empty() && !progress.cancelled()) {
    HoleSequence again = filling;
    again.run(tasks, progress.part(0.7, 1.0));
    if (again.openCount() < filling.openCount()) {
      mesh = again.mesh();
      return again.takeFills();
    }
  }
  mesh = filling.mesh();
  return filling.takeFills();
}

}  // namespace handwheel
