// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnStatistics.h"

#include "base/NumberText.h"
#include "document/FileBytes.h"
#include "machining/lathe/LatheMaterial.h"
#include "machining/refit/SampledProfile.h"
#include "machining/section/SectionOutline.h"
#include "machining/target/TargetDeviation.h"
#include "machining/target/files/Drawing.h"
#include "machining/target/files/DxfReader.h"
#include "machining/target/files/SvgReader.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSection = 1e-3;  // mm, of the section of a workpiece that is a target

// Returns the roughness of the outside: "Roughness: up to Ra 1.2 µm." Empty if it is not known.
std::string roughestText(const nlohmann::json& finish) {
  double roughest = -1.0;
  for (const nlohmann::json& stretch : finish.is_object() ? finish["outside"] : nlohmann::json::array()) {
    if (stretch["roughness_um"].is_number()) roughest = std::max(roughest, stretch["roughness_um"].get<double>());
  }
  return roughest < 0.0 ? std::string() : "Roughness: up to Ra " + roundedText(roughest, 3) + " µm.\n";
}

// Returns a force in newtons with four digits, without an exponent.
std::string forceText(double newtons) {
  if (!std::isfinite(newtons)) return "unknown";
  return newtons < 1000.0 ? roundedText(newtons, 4) : std::to_string(std::llround(newtons));
}

// Returns the power that the motor of a usual drive needs for the heaviest cut, kW.
double motorPowerOf(const TurnStatistics& figures) {
  return motorPower(figures.power, SpindleDrive().efficiency);
}

}  // namespace

bool addLoads(TurnStatistics& figures, const WorkpieceSnapshot& given, const WorkpieceSnapshot& turned,
              const WorkMaterial& material, double spindle, Progress progress) {
  ReviewedLathe lathe;
  lathe.spindleSpeed = spindle;
  const auto peaks = loadPeaks(turned, given.part.get(), material, lathe, progress);
  if (!peaks) {
    figures.force = figures.power = std::nan("");
    return false;
  }
  figures.force = peaks->force;
  figures.power = peaks->power * SpindleDrive().efficiency;
  figures.drilling = peaks->drilling;
  return true;
}

std::vector<TurnStatistics::Piece> partedOff(const TurnedPart* before, const TurnedPart& after) {
  std::vector<TurnStatistics::Piece> parted;
  for (const TurnedSection& piece : after.partedSince(before))
    parted.push_back({piece.box().sizes().y(), after.volumeOf(piece)});
  return parted;
}

std::string statisticsAsJson(const TurnStatistics& figures) {
  nlohmann::ordered_json json = {{"removed_mm3", figures.removed}, {"max_force_N", figures.force},
                                 {"max_power_kW", figures.power},  {"max_motor_power_kW", motorPowerOf(figures)},
                                 {"collisions", nullptr},          {"time_s", figures.time},
                                 {"profile_error_mm", nullptr}};
  if (figures.collisions) json["collisions"] = *figures.collisions;
  if (figures.profileError) json["profile_error_mm"] = *figures.profileError;
  json["finish"] = figures.finish;
  if (const DrillPeaks& drilling = figures.drilling; drilling.diameter > 0.0)
    json["drilling"] = {{"diameter_mm", drilling.diameter},
                        {"thrust_N", drilling.thrust},
                        {"torque_Nm", drilling.torque},
                        {"power_kW", drilling.power}};
  for (const TurnStatistics::Piece& piece : figures.parted)
    json["parted_off"].push_back({{"length_mm", piece.length}, {"volume_mm3", piece.volume}});
  for (const ToolPath::Note& note : figures.warnings)
    json["warnings"].push_back({{"line", note.line}, {"text", note.text}});
  return json.dump(2) + "\n";
}

std::string statisticsAsText(const TurnStatistics& figures) {
  std::string text =
      "Removed: " + roundedText(figures.removed) + " mm³. Largest resultant force: " + forceText(figures.force) +
      " N, power at the cut: " + roundedText(figures.power, 4) +
      " kW, motor power: " + roundedText(motorPowerOf(figures), 4) + " kW. Time: " + roundedText(figures.time, 5) +
      " s." + (figures.collisions ? " Collisions: " + std::to_string(*figures.collisions) + "." : "") + "\n";
  if (const DrillPeaks& drilling = figures.drilling; drilling.diameter > 0.0)
    text += "Drilling: thrust " + forceText(drilling.thrust) + " N, torque " + roundedText(drilling.torque, 3) +
            " N·m, power " + roundedText(drilling.power, 3) + " kW.\n";
  for (const TurnStatistics::Piece& piece : figures.parted)
    text += "Parted off: a piece of " + roundedText(piece.length, 5) + " mm length and " + roundedText(piece.volume) +
            " mm³.\n";
  text += roughestText(figures.finish);
  if (figures.profileError) text += "Deviation from the target: " + roundedText(*figures.profileError, 4) + " mm.\n";
  return text;
}

Result<TargetProfile> readTarget(const std::filesystem::path& path, const DocumentKinds& kinds, Progress progress) {
  const std::string ending = path.extension().string();
  if (ending == ".dxf" || ending == ".svg") {
    const Result<std::string> text = readFileBytes(path, progress);
    if (!text) return text.error();
    const Result<Drawing> drawing = ending == ".dxf" ? readDxf(*text, progress) : readSvg(*text, progress);
    if (!drawing) return drawing.error();
    return targetIn(*drawing, progress);
  }
  const Result<OpenedFile> opened = kinds.open(path, {}, progress);
  if (!opened) return opened.error();
  const auto* const workpiece = dynamic_cast<const WorkpieceSnapshot*>(opened->content.get());
  if (!workpiece)
    return Error{ErrorCode::Unsupported, {"a target that is not a workpiece or a drawing"}, {}, path.string()};
  if (workpiece->part) return outlineOf(workpiece->part->section(), kSection, 0.0);
  return sectionOf(workpiece->stock.profile(), kSection);
}

double profileError(const TargetProfile& target, const TurnedProfile& part) {
  const double base = target.upperEnd() - part.length();
  const TargetDeviation deviation = deviationFrom(target, part, base);
  double largest = 0.0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double z = part.z(i) + base;
    if (z < target.lowerEnd() + part.spacing() || z > target.upperEnd() - part.spacing()) continue;
    for (const double off : {deviation.outer[i], deviation.inner[i]})
      if (std::isfinite(off)) largest = std::max(largest, std::abs(off));
  }
  return largest;
}

}  // namespace handwheel
