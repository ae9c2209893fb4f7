// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ShippedExercises.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

namespace handwheel {

namespace {

constexpr std::string_view kShippedKey = "handwheel-";

// The texts of resources/samples/exercises, which tools/exercises wrote; a test compares them.
// NOLINTBEGIN(bugprone-suspicious-missing-comma): long texts among short ones
constexpr const char* kTexts[] = {
    QT_TRANSLATE_NOOP("Exercise", "turning tool"),
    QT_TRANSLATE_NOOP("Exercise", "boring bar"),
    QT_TRANSLATE_NOOP("Exercise", "parting tool"),
    QT_TRANSLATE_NOOP("Exercise", "threading tool of 60°"),
    QT_TRANSLATE_NOOP("Exercise", "On the lathe, drill first: a boring bar needs a hole to begin in."),
    QT_TRANSLATE_NOOP("Exercise", "Ball"),
    QT_TRANSLATE_NOOP("Exercise", "A ball of 36 mm on a neck of 12 mm."),
    QT_TRANSLATE_NOOP("Exercise", "Rough"),
    QT_TRANSLATE_NOOP("Exercise", "Take the material off in passes of 1.5 mm and leave 0.4 mm on the radius."),
    QT_TRANSLATE_NOOP("Exercise", "Begin each pass in the air at the end of the bar."),
    QT_TRANSLATE_NOOP("Exercise", "The read-out shows the diameter: 0.4 mm on the radius are 0.8 mm on the diameter."),
    QT_TRANSLATE_NOOP("Exercise", "Move both slides at once along the circle."),
    QT_TRANSLATE_NOOP("Exercise", "Begin at the pole, where the ball ends, and go towards the chuck."),
    QT_TRANSLATE_NOOP("Exercise", "Finish"),
    QT_TRANSLATE_NOOP("Exercise", "Follow the outline in one pass at 0.1 mm per revolution."),
    QT_TRANSLATE_NOOP("Exercise", "The slower the feed, the finer the surface."),
    QT_TRANSLATE_NOOP("Exercise", "Form within 0.1 mm"),
    QT_TRANSLATE_NOOP("Exercise", "Radius 18 ±0.1"),
    QT_TRANSLATE_NOOP("Exercise", "Finish N8"),
    QT_TRANSLATE_NOOP("Exercise", "No collision, no feed too high"),
    QT_TRANSLATE_NOOP("Exercise", "Cutting force within that of the lathe"),
    QT_TRANSLATE_NOOP("Exercise", "Power within that of the motor"),
    QT_TRANSLATE_NOOP("Exercise", "In the time"),
    QT_TRANSLATE_NOOP("Exercise", "Without many hints"),
    QT_TRANSLATE_NOOP("Exercise", "Bored bush"),
    QT_TRANSLATE_NOOP("Exercise", "A bush with a bore to H10."),
    QT_TRANSLATE_NOOP("Exercise", "Outside"),
    QT_TRANSLATE_NOOP("Exercise", "Turn ⌀44 over 30 mm."),
    QT_TRANSLATE_NOOP("Exercise", "Bore"),
    QT_TRANSLATE_NOOP("Exercise", "Bore in passes of 1.5 mm to 0.4 mm below the size."),
    QT_TRANSLATE_NOOP("Exercise", "The bore has no chips to see: listen."),
    QT_TRANSLATE_NOOP("Exercise", "Finish the bore"),
    QT_TRANSLATE_NOOP("Exercise", "One pass at 0.1 mm per revolution."),
    QT_TRANSLATE_NOOP("Exercise", "⌀25 H10 bore"),
    QT_TRANSLATE_NOOP("Exercise", "Depth 28 ±0.2"),
    QT_TRANSLATE_NOOP("Exercise", "Dumb-bell weight"),
    QT_TRANSLATE_NOOP("Exercise", "Two equal heads with a handle between them."),
    QT_TRANSLATE_NOOP("Exercise", "Handle"),
    QT_TRANSLATE_NOOP("Exercise", "Turn the handle between the two heads."),
    QT_TRANSLATE_NOOP("Exercise", "The faces of the heads are 34 mm apart."),
    QT_TRANSLATE_NOOP("Exercise", "Handle 34 ±0.2"),
    QT_TRANSLATE_NOOP("Exercise", "Your first shoulder"),
    QT_TRANSLATE_NOOP("Exercise",
                      "Turn the end of a bar of 40 mm down to 30 mm, over a length of 30 mm. It takes a few minutes."),
    QT_TRANSLATE_NOOP("Exercise", "Choose the tool"),
    QT_TRANSLATE_NOOP("Exercise",
                      "Press V, or choose “Turn” above. A round tool appears at the pointer; the grey bar turns all "
                      "the time, so only the distance from its axis matters."),
    QT_TRANSLATE_NOOP("Exercise", "First pass"),
    QT_TRANSLATE_NOOP(
        "Exercise",
        "Go with the pointer to the right end of the bar, just inside its edge. Hold the left button, and drag slowly "
        "along the bar over 30 mm. The label shows the diameter ⌀ that is left, and the feed f: more than 1 mm per "
        "revolution, 13 mm a second, is too fast; below 0.25 mm the surface becomes fine."),
    QT_TRANSLATE_NOOP("Exercise",
                      "Nothing is cut while the tool is outside of the bar. Begin beyond its end and come in slowly."),
    QT_TRANSLATE_NOOP("Exercise", "Ctrl+Z takes a pass back."),
    QT_TRANSLATE_NOOP("Exercise", "Go deeper"),
    QT_TRANSLATE_NOOP("Exercise", "Repeat it a little deeper each time, until the label shows ⌀30."),
    QT_TRANSLATE_NOOP("Exercise", "Two or three passes are enough."),
    QT_TRANSLATE_NOOP("Exercise", "The shoulder"),
    QT_TRANSLATE_NOOP("Exercise", "Let the pass end 30 mm from the end, so that a face stands there."),
    QT_TRANSLATE_NOOP("Exercise",
                      "Z in the label is the place of the face that the tool leaves, from the finished end of the bar: "
                      "stop at Z -30."),
    QT_TRANSLATE_NOOP("Exercise", "Measure"),
    QT_TRANSLATE_NOOP("Exercise", "Press “Measure” below. Lines with ✓ are right; with ✗, take another pass."),
    QT_TRANSLATE_NOOP("Exercise", "Length 30 ±1"),
    QT_TRANSLATE_NOOP("Exercise", "Gourd"),
    QT_TRANSLATE_NOOP("Exercise", "Two bulbs with a waist, by hand and eye."),
    QT_TRANSLATE_NOOP("Exercise", "Waist"),
    QT_TRANSLATE_NOOP("Exercise", "Find the narrowest place, 36 mm from the end."),
    QT_TRANSLATE_NOOP("Exercise", "Plunge a little, measure, and plunge again."),
    QT_TRANSLATE_NOOP("Exercise", "Form within 0.15 mm"),
    QT_TRANSLATE_NOOP("Exercise", "Shaft with shoulders"),
    QT_TRANSLATE_NOOP("Exercise", "Three diameters to h10 with exact lengths."),
    QT_TRANSLATE_NOOP("Exercise", "First shoulder"),
    QT_TRANSLATE_NOOP("Exercise", "Turn ⌀20 over 30 mm."),
    QT_TRANSLATE_NOOP("Exercise", "Touch off at the end first."),
    QT_TRANSLATE_NOOP("Exercise", "Second shoulder"),
    QT_TRANSLATE_NOOP("Exercise", "Turn ⌀28 over the next 30 mm."),
    QT_TRANSLATE_NOOP("Exercise", "Third shoulder"),
    QT_TRANSLATE_NOOP("Exercise", "Turn ⌀36 over 25 mm."),
    QT_TRANSLATE_NOOP("Exercise", "Length 30 ±0.1"),
    QT_TRANSLATE_NOOP("Exercise", "Thread M20"),
    QT_TRANSLATE_NOOP("Exercise", "A thread M20 × 2.5 - 6g with relief and chamfer."),
    QT_TRANSLATE_NOOP("Exercise", "Major diameter"),
    QT_TRANSLATE_NOOP("Exercise", "Turn to 19.8 mm, as a thread M20 with a pitch of 2.5 mm begins."),
    QT_TRANSLATE_NOOP("Exercise", "Relief"),
    QT_TRANSLATE_NOOP("Exercise", "Groove to 16.4 mm beside the collar, where the thread runs out."),
    QT_TRANSLATE_NOOP("Exercise", "Thread"),
    QT_TRANSLATE_NOOP(
        "Exercise",
        "Cut the thread with the tool of 60°: passes of falling depth, down to a pitch diameter of 18.25 mm."),
    QT_TRANSLATE_NOOP(
        "Exercise",
        "On the lathe, set the pitch and close the half-nut in front of the end of the bar; open it in the relief."),
    QT_TRANSLATE_NOOP("Exercise", "A lead that is a part of the lead screw's pitch always finds its groove again."),
    QT_TRANSLATE_NOOP("Exercise", "⌀20 6g major diameter"),
    QT_TRANSLATE_NOOP("Exercise", "Pitch 2.5 ±0.02"),
    QT_TRANSLATE_NOOP("Exercise", "Pitch diameter 18.376 6g"),
    QT_TRANSLATE_NOOP("Exercise", "Minor diameter 6g"),
    QT_TRANSLATE_NOOP("Exercise", "To the collar 40 ±0.2"),
    QT_TRANSLATE_NOOP("Exercise", "Chamfer 45°"),
    QT_TRANSLATE_NOOP("Exercise", "Wine glass"),
    QT_TRANSLATE_NOOP("Exercise", "A glass with a hollow bowl on a thin stem."),
    QT_TRANSLATE_NOOP("Exercise", "Hollow the bowl"),
    QT_TRANSLATE_NOOP("Exercise", "Bore from the end in passes of 1.5 mm, while the stem is still thick."),
    QT_TRANSLATE_NOOP("Exercise", "What is hollowed last breaks the stem."),
    QT_TRANSLATE_NOOP("Exercise", "Stem"),
    QT_TRANSLATE_NOOP("Exercise", "Turn the stem to 8 mm."),
    QT_TRANSLATE_NOOP("Exercise", "Small cuts: the stem bends."),
    QT_TRANSLATE_NOOP("Exercise", "Part off"),
    QT_TRANSLATE_NOOP("Exercise", "Part the glass off below its foot."),
    QT_TRANSLATE_NOOP("Exercise", "Straight in to the axis, at a small feed."),
    QT_TRANSLATE_NOOP("Exercise", "Depth of the bowl 39 ±0.5"),
    QT_TRANSLATE_NOOP("Exercise", "Burr hole in the skull"),
    QT_TRANSLATE_NOOP("Exercise", "Drill through the skull along the planned path, and stop before the brain."),
    QT_TRANSLATE_NOOP("Exercise", "Choose the drill"),
    QT_TRANSLATE_NOOP("Exercise",
                      "Press Shift+D, or choose “Drill” above. Drill, speed and material are those of the exercise. "
                      "The green rod shows the planned path."),
    QT_TRANSLATE_NOOP("Exercise", "Find the place"),
    QT_TRANSLATE_NOOP("Exercise",
                      "Go with the pointer to where the green rod meets the skull. The circle shows the drill."),
    QT_TRANSLATE_NOOP("Exercise", "Turn the view until you look along the rod."),
    QT_TRANSLATE_NOOP("Exercise", "With Shift held, the drill goes straight along the view."),
    QT_TRANSLATE_NOOP("Exercise", "Drill"),
    QT_TRANSLATE_NOOP("Exercise",
                      "Hold the left button: the drill goes on at its feed, and the plots show thrust and torque. Let "
                      "go as soon as the breakthrough is shown."),
    QT_TRANSLATE_NOOP("Exercise", "The thrust falls when the tip comes through the inner table."),
    QT_TRANSLATE_NOOP("Exercise", "Ctrl+Z takes a hole back, and with it all that was measured of it."),
    QT_TRANSLATE_NOOP("Exercise", "Measure the hole"),
    QT_TRANSLATE_NOOP("Exercise", "Press “Measure” below."),
    QT_TRANSLATE_NOOP("Exercise", "The brain is not touched"),
    QT_TRANSLATE_NOOP("Exercise", "Stopped within 2 mm"),
    QT_TRANSLATE_NOOP("Exercise", "On the planned path"),
    QT_TRANSLATE_NOOP("Exercise", "Through within 20 s"),
    QT_TRANSLATE_NOOP("Exercise", "Thrust below 30 N"),
    QT_TRANSLATE_NOOP("Exercise", "Gentle in the last millimetre"),
    QT_TRANSLATE_NOOP("Exercise", "Torque below 150 N·mm"),
    QT_TRANSLATE_NOOP("Exercise", "Cool drilling"),
};
// NOLINTEND(bugprone-suspicious-missing-comma)

void translate(std::string& text) {
  const auto* const found = std::find(std::begin(kTexts), std::end(kTexts), text);
  if (found != std::end(kTexts)) text = QCoreApplication::translate("Exercise", *found).toStdString();
}

}  // namespace

std::span<const char* const> shippedExerciseTexts() {
  return kTexts;
}

Exercise inLanguage(const ExerciseSnapshot& snapshot) {
  Exercise exercise = snapshot.exercise;
  if (!snapshot.key.starts_with(kShippedKey)) return exercise;
  translate(exercise.title);
  translate(exercise.text);
  for (MarkingCriterion& criterion : exercise.criteria) translate(criterion.name);
  for (ExerciseStep& step : exercise.steps) {
    translate(step.title);
    translate(step.text);
    for (std::string& hint : step.hints) translate(hint);
  }
  return exercise;
}

}  // namespace handwheel
