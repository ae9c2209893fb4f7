// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/mesh/MeshServices.h"

#include <deque>

namespace handwheel::test {

// Jobs and changes that wait, as on workers, until the test continues them.
struct WaitingServices {
  std::shared_ptr<const FaceHierarchy> faces;
  std::deque<ToolJob> jobs;
  std::deque<MeshChange> changes;
  int cancelled = 0;

  MeshServices services() {
    return {[this] { return faces; }, [this](ToolJob job) { jobs.push_back(std::move(job)); }, [this] { ++cancelled; },
            [this](MeshChange change) { changes.push_back(std::move(change)); }};
  }
  // Removes the first job and does its work. The returned function delivers its result.
  std::function<void()> work() {
    const ToolJob job = std::move(jobs.front());
    jobs.pop_front();
    return job.work(Progress());
  }
};

}  // namespace handwheel::test
