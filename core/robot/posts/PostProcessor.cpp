// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/NumberText.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

// Returns the error for statements of another language, which this one cannot have.
std::optional<Error> linesOfOther(const RobotProgram& program, const PostProcessor& post) {
  if (program.language == post.id()) return std::nullopt;
  constexpr std::size_t kMostListed = 10;
  std::vector<const ProgramLine*> all;
  const auto add = [&](const std::vector<ProgramLine>& lines) {
    for (const ProgramLine& line : lines) {
      const bool isDroppable = line.kind == ProgramLine::Kind::Comment || line.kind == ProgramLine::Kind::Declaration;
      if (!isDroppable) all.push_back(&line);
    }
  };
  add(program.head);
  for (const ProgramMotion& motion : program.motions) add(motion.lines);
  if (all.empty()) return std::nullopt;
  std::string numbers;
  for (std::size_t i = 0; i < std::min(all.size(), kMostListed); ++i)
    numbers += (i > 0 ? ", " : "") + std::to_string(all[i]->line);
  if (all.size() > kMostListed) numbers += ", …";
  const PostProcessor* const language = postCalled(program.language);
  return Error{PostError::LinesOfOther,
               {all.front()->text, post.title(), language ? language->title() : program.language, numbers},
               {},
               {}};
}

}  // namespace

std::vector<Error> PostProcessor::refusals(const RobotProgram& program) const {
  std::vector<Error> all;
  if (program.motions.size() > kMostMotions) {
    all.push_back(
        {PostError::TooManyMotions, {std::to_string(program.motions.size()), std::to_string(kMostMotions)}, {}, {}});
  }
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    const ProgramMotion& motion = program.motions[i];
    const bool isSound = motion.joints.allFinite() && std::isfinite(motion.speed) && std::isfinite(motion.blend);
    if (!isSound || motion.joints.size() != program.arm.size())
      all.push_back({PostError::NotFinite, {std::to_string(i + 1)}, {}, {}});
    if (motion.corner > 0.0 && !hasCorners())
      all.push_back({PostError::NoCorners, {std::to_string(i + 1), title()}, {}, {}});
  }
  if (const auto lines = linesOfOther(program, *this)) all.push_back(*lines);
  return all;
}

std::vector<Error> ControllerPost::refusals(const RobotProgram& program) const {
  std::vector<Error> all = PostProcessor::refusals(program);
  constexpr Eigen::Index kJoints = 6;
  if (program.arm.size() != kJoints) {
    all.push_back(
        {PostError::WrongJoints, {title(), std::to_string(kJoints), std::to_string(program.arm.size())}, {}, {}});
  }
  for (std::size_t i = 0; i < program.arm.joints().size(); ++i) {
    if (program.arm.joints()[i].isPrismatic)
      all.push_back({PostError::NoSlides, {title(), std::to_string(i + 1)}, {}, {}});
  }
  for (std::size_t i = 0; i < program.motions.size() && program.arm.coupling(); ++i) {
    const AxisCoupling& coupling = *program.arm.coupling();
    const ArmValues& joints = program.motions[i].joints;
    if (joints.size() != program.arm.size() || coupling.isWithin(joints, 1e-6)) continue;
    all.push_back({PostError::ThirdBeyond,
                   {std::to_string(i + 1), shownText(coupling.third(joints) / kRadiansPerDegree),
                    shownText(coupling.lower / kRadiansPerDegree), shownText(coupling.upper / kRadiansPerDegree)},
                   {},
                   {}});
  }
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    const ProgramMotion& motion = program.motions[i];
    if (motion.kind != ProgramMotion::Kind::Linear || !(motion.speed > fastestLine())) continue;
    all.push_back({PostError::TooFast,
                   {std::to_string(i + 1), shownText(motion.speed), title(), shownText(fastestLine())},
                   {},
                   {}});
  }
  return all;
}

namespace {

std::function<std::vector<std::unique_ptr<PostProcessor>>()>& pluginSource() {
  static std::function<std::vector<std::unique_ptr<PostProcessor>>()> source;
  return source;
}

std::vector<std::unique_ptr<PostProcessor>> allPosts() {
  std::vector<std::unique_ptr<PostProcessor>> all;
  all.push_back(std::make_unique<RapidPost>());
  all.push_back(std::make_unique<KrlPost>());
  all.push_back(std::make_unique<FanucPost>());
  all.push_back(std::make_unique<UrScriptPost>());
  all.push_back(makeCsvPost());
  all.push_back(makeJsonPost());
  if (!pluginSource()) return all;
  for (std::unique_ptr<PostProcessor>& post : pluginSource()()) {
    const std::string_view id = post->id();
    const bool isNew = std::none_of(all.begin(), all.end(), [&](const auto& other) { return other->id() == id; });
    if (isNew) all.push_back(std::move(post));
  }
  return all;
}

}  // namespace

void setPluginPosts(std::function<std::vector<std::unique_ptr<PostProcessor>>()> source) {
  pluginSource() = std::move(source);
}

std::span<const std::unique_ptr<PostProcessor>> posts() {
  static const std::vector<std::unique_ptr<PostProcessor>> kAll = allPosts();
  return kAll;
}

const PostProcessor* postCalled(std::string_view id) {
  for (const auto& post : posts()) {
    if (post->id() == id) return post.get();
  }
  return nullptr;
}

const PostProcessor* postForEnding(std::string_view fileName) {
  std::string lower(fileName);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(c < 128 ? std::tolower(c) : c); });
  for (const auto& post : posts()) {
    if (lower.ends_with(post->ending())) return post.get();
  }
  return nullptr;
}

namespace {

// Compares with Fanuc's steps, which are the coarsest: whole percent, tenths of mm/s. Lower speeds become one step.
bool isSameSpeed(ProgramMotion::Kind kind, double wanted, double got) {
  const double step = kind == ProgramMotion::Kind::Joint ? 0.01 : 0.1;
  return std::abs(wanted - got) <= 0.501 * step || (wanted <= step && got <= step);
}

std::optional<Error> differenceOf(const ProgramMotion& wanted, const ParsedMotion& got, std::size_t number) {
  const auto differs = [&](const char* what, const std::string& was, const std::string& is) {
    return Error{PostError::MotionDiffers, {std::to_string(number), what, was, is}, {}, {}};
  };
  constexpr double kBlendStep = 1e-3;  // mm
  const auto word = [](ProgramMotion::Kind kind) { return kind == ProgramMotion::Kind::Joint ? "joint" : "linear"; };
  if (wanted.kind != got.kind) return differs("kind", word(wanted.kind), word(got.kind));
  if (got.speed && got.seconds <= 0.0 && !isSameSpeed(wanted.kind, wanted.speed, *got.speed))
    return differs("speed", fixedText(wanted.speed, 4), fixedText(*got.speed, 4));
  if (!(got.blend <= wanted.blend + kBlendStep))
    return differs("blend", fixedText(wanted.blend, 4), fixedText(got.blend, 4));
  constexpr double kPercentStep = 0.51, kTimeStep = 0.06;  // s; Fanuc has tenths of long durations
  // A larger rounding than the path has is not proven.
  if (got.corner > wanted.corner + kPercentStep)
    return differs("rounding", fixedText(wanted.corner, 1), fixedText(got.corner, 1));
  if (got.seconds > 0.0 && std::abs(got.seconds - wanted.seconds) > kTimeStep)
    return differs("duration", fixedText(wanted.seconds, 3), fixedText(got.seconds, 3));
  return std::nullopt;
}

// Returns the texts of lines that are written: declarations first, as they may be moved there, and without empty ones.
std::vector<std::string> writtenTexts(const std::vector<ProgramLine>& lines) {
  std::vector<ProgramLine> all;
  std::ranges::copy_if(lines, std::back_inserter(all), [](const ProgramLine& line) { return !line.text.empty(); });
  std::ranges::stable_sort(all, {}, [](const ProgramLine& line) {
    return line.kind == ProgramLine::Kind::Declaration ? 0 : line.kind == ProgramLine::Kind::Axes ? 1 : 2;
  });
  std::vector<std::string> texts;
  for (const ProgramLine& line : all) texts.push_back(keptText(line, "! "));
  return texts;
}

// Compares the lines at a motion.
std::optional<Error> differenceOf(const std::vector<ProgramLine>& wanted, const std::vector<ProgramLine>& got,
                                  std::size_t number) {
  const std::vector<std::string> before = writtenTexts(wanted), after = writtenTexts(got);
  const auto [was, is] = std::ranges::mismatch(before, after);
  if (was == before.end() && is == after.end()) return std::nullopt;
  const auto shown = [](auto at, auto end) { return at == end ? std::string("-") : *at; };
  return Error{PostError::MotionDiffers,
               {std::to_string(number), "line", shown(was, before.end()), shown(is, after.end())},
               {},
               {}};
}

void compare(const Pose& wanted, const Pose& got, PostCheck& check) {
  if (!got.matrix().allFinite()) check.distance = std::numeric_limits<double>::infinity();
  check.distance = std::max(check.distance, (got.translation() - wanted.translation()).norm());
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(got.linear().transpose() * wanted.linear()));
  check.angle = std::max(check.angle, std::abs(turn.angle()) / kRadiansPerDegree);
}

}  // namespace

Result<PostCheck> checkWritten(const PostProcessor& post, const RobotProgram& program, std::string_view text) {
  const Result<std::vector<ParsedMotion>> read = post.read(text, program);
  if (!read) return read.error();
  PostCheck check;
  check.motions = read->size();
  if (read->size() != program.motions.size()) {
    return Error{ErrorCode::CountMismatch,
                 {"motions", std::to_string(program.motions.size()), std::to_string(read->size())},
                 {},
                 {}};
  }
  for (std::size_t i = 0; i < read->size(); ++i) {
    const ParsedMotion& motion = (*read)[i];
    if (const auto difference = differenceOf(program.motions[i], motion, i + 1)) return *difference;
    const bool hasLines = program.language == post.id();  // other languages have comments only, and change these
    const auto lines = hasLines ? differenceOf(program.motions[i].lines, motion.lines, i + 1) : std::nullopt;
    const auto head = hasLines && i == 0 ? differenceOf(program.head, motion.before, 1) : std::nullopt;
    if (head || lines) return head ? *head : *lines;
    const Pose wanted = program.frame.inverse(Eigen::Isometry) * program.tipOf(program.motions[i]);
    const Pose got =
        motion.joints
            ? Pose(program.frame.inverse(Eigen::Isometry) * program.arm.tipPose(*motion.joints) * program.tool)
            : *motion.pose;
    compare(wanted, got, check);
    if (!motion.frame) continue;
    compare(program.frame, *motion.frame, check);
    check.isInFrame = true;
  }
  return check;
}

}  // namespace handwheel
