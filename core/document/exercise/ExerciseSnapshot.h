// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"
#include "document/exercise/MarkedSubmissions.h"
#include "exercise/Attempt.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The value of an exercise document. Of a teacher's, with its answers; of a student's, without them; or of one that was
// handed in, with the work.
struct ExerciseSnapshot : Snapshot {
  std::string key;  // the same in the teacher's file, the students' and what they hand in
  Exercise exercise;
  const ExerciseSubject* subject = nullptr;         // never null in a document
  TaskPointer task;                                 // never null in a document
  SnapshotPointer solution;                         // the model solution; null: none
  SnapshotPointer work;                             // of the student, as far as it is; null: nothing yet
  std::optional<Attempt> attempt;                   // present since the student has begun
  bool isForStudents = false;                       // it has no answers, and cannot be changed
  std::shared_ptr<const MarkedSubmissions> marked;  // what was handed in, as it was marked; null: nothing yet
  // What the file that it was read from has beside what this program knows: it is written back into files. What rows
  // have is in them. Null: nothing.
  std::shared_ptr<const nlohmann::json> others;
  // The model solution as it was described, and what was made of that: as long as this is the model solution it is
  // written as it was read. Null: it was not described.
  std::shared_ptr<const nlohmann::json> describedSolution;
  SnapshotPointer madeOfDescription;
};

// The exercise for students: without marking scheme, model solution, work and class.
ExerciseSnapshot forStudents(ExerciseSnapshot exercise);

// Marks the work of an exercise by the scheme of another, the teacher's. Measures the common figures as well. The
// subjects must be the same.
Marking markWork(const ExerciseSnapshot& scheme, const Snapshot& work, const Attempt& attempt, Progress progress = {});

// The type of a figure of this subject or of the common ones; null when it is unknown.
const MeasurementType* measurementType(std::span<const MeasurementType> types, std::string_view id);
// All of a subject, its own first.
std::vector<MeasurementType> measurementTypes(const ExerciseSubject& subject);

}  // namespace handwheel
