// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/TurnTool.h"

#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/target/TargetPosition.h"
#include "tools/ToolProperty.h"
#include "tools/workpiece/AxisPlane.h"
#include "tools/workpiece/PassNames.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr Limits kNoseRadii{TurningPass::kLeastNose, TurningPass::kLargestNose};
constexpr Limits kResistances{1e-3, 10.0};  // N·s/mm
constexpr Limits kResolutions{0.05, 10.0};  // mm, as turn.resolution

// The circle of the nose in the half plane through the axis.
std::vector<Vec3> noseOutline(const Vec3& centre, double radius) {
  constexpr int kSides = 48;
  const double r = std::hypot(centre.x(), centre.y());
  const Vec3 outward = r > 0.0 ? Vec3(centre.x() / r, centre.y() / r, 0.0) : Vec3(Vec3::UnitX());
  std::vector<Vec3> line;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    line.push_back(centre + radius * (std::cos(angle) * outward + std::sin(angle) * Vec3::UnitZ()));
  }
  return line;
}

// mm. Of an uncut bar the radius is that of the bar.
double radiusAt(const WorkpieceSnapshot& workpiece, double z, TurningSide side) {
  const bool isBore = side == TurningSide::Bore;
  if (!workpiece.part) return isBore ? 0.0 : 0.5 * workpiece.stock.diameter;
  const TurnedProfile& profile = workpiece.part->profile;
  const double at = std::clamp(z / profile.spacing(), 0.0, static_cast<double>(profile.size() - 1));
  const auto i = static_cast<std::size_t>(std::min(std::floor(at), static_cast<double>(profile.size() - 2)));
  const auto radius = [&](std::size_t k) { return isBore ? profile.inner(k) : profile.radius(k); };
  return std::lerp(radius(i), radius(i + 1), at - static_cast<double>(i));
}

// Returns the text of a pass for the history. removed: mm³.
QString passText(const TurnedPart& part, double removed) {
  QString text = passesText(part, part.passes.size() - 1, removed);
  if (const std::size_t pieces = part.profile.pieces().size(); pieces > 1)
    text += QCoreApplication::translate("Tool", "; the part is now in %n piece(s)", nullptr, static_cast<int>(pieces));
  return text;
}

}  // namespace

TurnTool::TurnTool(WorkpieceDocument& document, const SimulationServices& services, const Start& start)
    : m_document(document),
      m_start(start),
      m_present(start.spacing),
      m_tool{std::clamp(start.noseRadius, TurningPass::kLeastNose, TurningPass::kLargestNose)},
      m_gesture(services, m_channel->inputs, kRate, [this] { return simulation(); }) {}

std::span<const ToolKey> TurnTool::keys() {
  static const ToolKey kKeys[] = {{"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "discard the pass")}};
  return kKeys;
}

// Returns a pass with the present tool that has no points yet.
TurningPass TurnTool::blankPass() const {
  TurningPass blank;
  blank.noseRadius = m_tool.noseRadius;
  blank.side = m_tool.side;
  blank.method = m_start.method;
  blank.resolution = m_start.resolution;
  return blank;
}

std::unique_ptr<Simulation> TurnTool::simulation() const {
  const TurnedPart part = m_present.of(m_document.workpiece());
  TurningFinish finish{part.finish, static_cast<std::uint32_t>(part.passes.size()),
                       latheOf(m_document.workpiece()).spindle.speed};
  return std::make_unique<TurningSimulation>(part.profile, part.surface, blankPass(), base(), m_channel,
                                             TurningPass::kMostPoints, std::move(finish));
}

std::shared_ptr<const TurningState> TurnTool::state() const {
  return std::static_pointer_cast<const TurningState>(m_gesture.state());
}

std::optional<Vec3> TurnTool::positionOf(const PointerEvent& event) const {
  if (event.device) return event.proxy ? *event.proxy : Vec3(event.device->translation());
  const std::optional<Vec3> position = intersectAxisPlane(event.ray);
  if (!position) return std::nullopt;
  return Vec3(*position + (m_gesture.isOn() ? m_lift : liftAt(*position)));
}

// Straight away from the axis, or towards it in a bore, until the nose touches the part only. Where it does not fit in
// the bore, beyond the upper end.
Vec3 TurnTool::liftAt(const Vec3& position) const {
  const Vec3 across(position.x(), position.y(), 0.0);
  const double r = across.norm(), z = position.z() - base(), nose = m_tool.noseRadius;
  const TurnedProfile& profile = state()->profile;
  const ProfilePatch patch = patchAround(profile, z, nose, m_tool.side);
  const double depth = patch.penetration({sideways(m_tool.side, r), z}, nose);
  if (!(depth > 0.0)) return Vec3::Zero();
  if (m_tool.side == TurningSide::Bore && depth > r) return {0.0, 0.0, profile.length() + nose + profile.spacing() - z};
  return sideways(m_tool.side, depth) * (r > 0.0 ? Vec3(across / r) : Vec3::UnitX());
}

ToolReply TurnTool::press(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_gesture.isOn()) return ToolReply::Ignored;
  const std::optional<Vec3> position = positionOf(event);
  if (!position) return ToolReply::Ignored;
  if (!event.device) m_lift = *position - *intersectAxisPlane(event.ray);
  m_gesture.begin(event.device.has_value());
  m_position = position;
  if (!event.device) m_gesture.feed(*position, event.time);
  reportUpdated();
  return ToolReply::Used;
}

ToolReply TurnTool::pointer(const PointerEvent& event) {
  m_gesture.rethrow();
  const bool isOfDevice = event.device.has_value(), isOwn = m_gesture.isOnFrom(isOfDevice);
  switch (event.kind) {
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Release:
      return isOwn ? release() : ToolReply::Ignored;
    case PointerEvent::Kind::Leave:
      if (!m_gesture.isOn()) m_position.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Hover:
    case PointerEvent::Kind::Drag:
      break;
    case PointerEvent::Kind::DoubleClick:
      return ToolReply::Ignored;
  }
  if (m_gesture.isOn() && !isOwn) return ToolReply::Ignored;  // the other hand
  m_position = positionOf(event);
  if (m_position && isOwn && !isOfDevice) m_gesture.feed(*m_position, event.time);
  return isOwn ? ToolReply::Used : ToolReply::Ignored;
}

// The edit comes back as documentChanged(), and the next simulation begins there.
ToolReply TurnTool::release() {
  const std::unique_ptr<Simulation> ended = m_gesture.end();
  const auto cut = std::static_pointer_cast<const TurningState>(ended->state());
  if (!cut->isCut) {
    m_gesture.restart();
    return ToolReply::Used;
  }
  m_tooFast = isTooFast(cut->fastest) ? std::optional(cut->fastest) : std::nullopt;
  TurnedPart before = m_present.of(m_document.workpiece());
  const double removed = before.profile.volume() - cut->profile.volume();
  const auto pass = std::make_shared<const TurningPass>(static_cast<const TurningSimulation&>(*ended).pass());
  TurnedProfile profile = cut->profile;
  settlePass(profile, before.profile, pass, static_cast<std::uint32_t>(before.passes.size()));
  auto passes = std::move(before.passes);
  passes.push_back(pass);
  auto turned =
      std::make_shared<const TurnedPart>(TurnedPart{std::move(profile), cut->surface, std::move(passes), cut->finish});
  const QString text = passText(*turned, removed);
  m_document.commit(text, std::make_unique<TurnedPartEdit>(std::move(turned)));
  return ToolReply::Used;
}

ToolReply TurnTool::perform(std::string_view action) {
  if (action != "revert" || !m_gesture.isOn()) return ToolReply::Ignored;
  m_gesture.restart();
  reportUpdated();
  return ToolReply::Used;
}

std::vector<ToolAction> TurnTool::actions() const {
  const bool isFull = m_gesture.isOn() && state()->isFull;
  std::string effect =
      isFull ? QT_TRANSLATE_NOOP("Tool", "the pass is full: release it") : QT_TRANSLATE_NOOP("Tool", "cut a pass");
  if (const double feed = state()->fastest; m_gesture.isOn() && !isFull && isTooFast(feed)) {
    const QLocale locale;
    effect = QCoreApplication::translate("Tool", "too fast: feed %1 mm/rev, at most %2")
                 .arg(locale.toString(feed, 'f', 1), locale.toString(m_start.largestFeed))
                 .toStdString();
  }
  return {{"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), effect},
          {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "discard the pass"), m_gesture.isOn()}};
}

// Diameter and height of the theoretical corner of the tool, which is at the work and at the chuck's side of its nose:
// where a shoulder comes to be. And how deep the nose is below the surface before the pass.
std::optional<ToolLabel> TurnTool::label() const {
  if (!m_position) return std::nullopt;
  const WorkpieceSnapshot& workpiece = m_document.workpiece();
  const StockCylinder& stock = workpiece.stock;
  const double centre = std::hypot(m_position->x(), m_position->y());
  const double r = std::max(0.0, centre - sideways(m_tool.side, m_tool.noseRadius));
  const double z = m_position->z() - base(), near = 0.5 * stock.diameter;
  if (r > 0.5 * stock.diameter + near || z < -near || z > stock.length + near) return std::nullopt;
  const double zero = shownZero(workpiece, bool(m_document.file().assigned));
  ToolLabel label{*m_position, {{"⌀", 2.0 * r}, {"Z", z - m_tool.noseRadius - zero}}};
  if (z >= 0.0 && z <= stock.length)
    label.figures.push_back({"", std::min(0.0, sideways(m_tool.side, r - radiusAt(workpiece, z, m_tool.side)))});
  if (m_start.largestFeed > 0.0 && m_gesture.isOn()) label.figures.push_back({"f", state()->fastest});
  return label;
}

ToolPreview TurnTool::preview() const {
  ToolPreview preview;
  if (m_position) preview.lines.push_back(noseOutline(*m_position, m_tool.noseRadius));
  if (const auto now = state(); now != m_shownState) {
    m_shownState = now;
    DisplayModel model = displayOf(now->surface, base());
    if (now->isCut || m_document.workpiece().part) showFinish(model, now->profile, now->finish);
    m_parted = showPartedOff(model, now->profile, std::move(m_parted));
    m_shown = std::make_shared<const DisplayModel>(std::move(model));
  }
  preview.label = label();
  preview.replaced = m_shown;  // from the start on, so that the blocks are built when the first pass begins
  return preview;
}

std::vector<Property> TurnTool::settings() const {
  return {numberSetting("nose_radius", QT_TRANSLATE_NOOP("Property", "Nose radius of the tool"), m_tool.noseRadius,
                        Quantity::Length, kNoseRadii),
          numberSetting("resistance", QT_TRANSLATE_NOOP("Property", "Drag of a chip 1 mm wide (N·s/mm)"),
                        m_tool.resistance, Quantity::Number, kResistances),
          choiceSetting("side", QT_TRANSLATE_NOOP("Property", "Turn"), static_cast<int>(m_tool.side),
                        {QT_TRANSLATE_NOOP("Property", "The outside"), QT_TRANSLATE_NOOP("Property", "A bore")}),
          choiceSetting("method", QT_TRANSLATE_NOOP("Property", "The part takes the shape of"),
                        static_cast<int>(m_start.method),
                        {QT_TRANSLATE_NOOP("Property", "The nose, exactly"),
                         QT_TRANSLATE_NOOP("Property", "A smooth curve near it")}),
          numberSetting("resolution", QT_TRANSLATE_NOOP("Property", "Distance of the points of the curve"),
                        m_start.resolution, Quantity::Length, kResolutions)};
}

void TurnTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (id == "nose_radius" && assignNumber(m_tool.noseRadius, value, kNoseRadii)) m_gesture.restart();
  if (id == "side" && assignChoice(m_tool.side, value, 2)) m_gesture.restart();
  if (id == "method" && assignChoice(m_start.method, value, 2)) m_gesture.restart();
  if (id == "resolution" && assignNumber(m_start.resolution, value, kResolutions)) m_gesture.restart();
  if (id == "resistance") assignNumber(m_tool.resistance, value, kResistances);
}

}  // namespace handwheel
