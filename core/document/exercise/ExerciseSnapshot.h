// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"
#include "document/exercise/MarkedSubmissions.h"
#include "exercise/Attempt.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The value of an exercise document. It is a teacher's exercise with the answers, a student's copy without them, or a
// submission with the work.
struct ExerciseSnapshot : Snapshot {
  std::string key;  // the same in the teacher's file, the students' copies and their submissions
  Exercise exercise;
  const ExerciseSubject* subject = nullptr;         // never null in a document
  TaskPointer task;                                 // never null in a document
  SnapshotPointer solution;                         // the model solution; null: none
  SnapshotPointer work;                             // the student's work so far; null: none yet
  std::optional<Attempt> attempt;                   // present once the student has begun
  bool isForStudents = false;                       // the copy has no answers and cannot be changed
  std::shared_ptr<const MarkedSubmissions> marked;  // the marked submissions; null: none yet
  // Keys of the file that this program does not know, to be written back. Unknown keys of rows are kept in the rows.
  // Null: there are none.
  std::shared_ptr<const nlohmann::json> others;
  // The model solution as it was described, and the work that was made from the description. The description is written
  // back unchanged while that work is the model solution. Null: the solution was not described.
  std::shared_ptr<const nlohmann::json> describedSolution;
  SnapshotPointer madeOfDescription;
};

// Returns the copy for students: without marking scheme, model solution, work and marked submissions.
ExerciseSnapshot forStudents(ExerciseSnapshot exercise);

// Marks work by the marking scheme of a teacher's exercise, `scheme`. The common figures are measured as well. The work
// must be a document of the exercise's subject.
Marking markWork(const ExerciseSnapshot& scheme, const Snapshot& work, const Attempt& attempt, Progress progress = {});

// Returns the type of a figure from a list of types. Returns null if the figure is not in the list.
const MeasurementType* measurementType(std::span<const MeasurementType> types, std::string_view id);
// Returns all types of a subject, its own first, then the common ones.
std::vector<MeasurementType> measurementTypes(const ExerciseSubject& subject);

}  // namespace handwheel
