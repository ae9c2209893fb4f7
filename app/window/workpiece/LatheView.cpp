// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/LatheView.h"

#include "audio/MachineSound.h"
#include "controls/ScrolledPanel.h"
#include "controls/machine/HandwheelDial.h"
#include "machining/lathe/LatheJson.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "simulation/turning/LatheForce.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "tools/workpiece/TurnTool.h"
#include "viewport/Viewport.h"
#include "viewport/path/PathLayer.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/haptics/SpaceMouseNavigation.h"
#include "window/tools/ToolHost.h"
#include "window/workpiece/LathePanel.h"
#include "window/workpiece/TextOutlines.h"
#include "window/workpiece/ZeroSymbol.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLocale>
#include <QMainWindow>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {
constexpr int kRefreshMs = 50;
constexpr int kSoundMs = 60;
constexpr int kAfterwardsMs = 2000;  // in which a crash rings out
constexpr double kOtherSize = 0.1;   // mm, between a size that was entered and that of the work: more is a slip
constexpr double kPushed = 20.0;     // mm for a height of the view: full deflection of a cap is some 20 mm/s
}  // namespace

LatheView::LatheView(const WindowContext& window, QObject* parent)
    : QObject(parent), m_window(window), m_zeroLayer(std::make_shared<PathLayer>()) {
  window.viewport.addLayer(m_zeroLayer);
  connect(&window.tools, &ToolHost::updated, this, &LatheView::follow);
  m_refresh.setInterval(kRefreshMs);
  connect(&m_refresh, &QTimer::timeout, this, &LatheView::refresh);
  m_sounding.setInterval(kSoundMs);
  window.viewport.installEventFilter(this);
  connect(&m_sounding, &QTimer::timeout, this, &LatheView::sound);
}

LatheView::~LatheView() {
  m_window.spaceMouse.setTaker({});
  m_window.viewport.removeLayer(*m_zeroLayer);
}

std::unique_ptr<Tool> LatheView::make(WorkpieceDocument& document) {
  const SimulationServices services{m_window.servoClock, m_window.services.simulation()};
  const FidelityValues& values = m_window.fidelity.values();
  std::shared_ptr<std::optional<ManualLatheTool::Left>>& left = m_left[&document].machine;
  if (!left) {
    left = std::make_shared<std::optional<ManualLatheTool::Left>>();
    connect(&document, &QObject::destroyed, this, [this](QObject* gone) { m_left.erase(gone); });
  }
  m_document = &document;
  const ManualLatheTool::Start start{values.of(turnSpacingSetting()),
                                     static_cast<ForceLaw>(static_cast<int>(values.of(forceModelSetting()))),
                                     values.of(turnStepSetting()), workLimits(document.file().assigned), left};
  return std::make_unique<ManualLatheTool>(document, services, shippedLatheTools(), start);
}

// Views the lathe from the operator's side: the axis from left to right, the chuck on the left, the tool on this side.
// A view that is already so is kept.
void LatheView::face(const ManualLatheTool& lathe) {
  constexpr double kFromAbove = 25.0 * M_PI / 180.0, kRoom = 1.15;
  Viewport& view = m_window.viewport;
  if (view.camera().right().z() > 0.9) return;
  const LatheChuck chuck = lathe.setup().chuck;
  const double first = chuck.grip - chuck.jawLength - chuck.length;
  const double last = lathe.moment()->profile.length() + 2.0 * chuck.grip;
  const Vec3 right(0.0, 0.0, 1.0), towards(std::cos(kFromAbove), -std::sin(kFromAbove), 0.0);
  Eigen::Matrix3d axes;
  axes << right, towards.cross(right), towards;
  CameraState camera = view.camera();
  camera.orientation = Eigen::Quaterniond(axes);
  camera.centre = Vec3(0.0, 0.0, lathe.base() + 0.5 * (first + last));
  const double shape = static_cast<double>(std::max(1, view.height())) / std::max(1, view.width());
  camera.height = kRoom * std::max(chuck.diameter, (last - first) * shape);
  view.setCamera(camera);
}

ManualLatheTool* LatheView::tool() const {
  // Only this view makes such a tool, and changes it only within calls of the runner.
  return const_cast<ManualLatheTool*>(dynamic_cast<const ManualLatheTool*>(m_window.tools.runner().tool()));
}

void LatheView::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_window.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Lathe"), window);
  m_dock->setObjectName(QStringLiteral("latheDock"));
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  m_panel = new LathePanel(m_dock);
  m_dock->setWidget(new ScrolledPanel(m_panel, ScrolledPanel::Directions::Both, m_dock));
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock);
  connect(m_panel, &LathePanel::commanded, this, [this](const LatheCommand& command) {
    if (ManualLatheTool* const lathe = tool()) m_window.tools.runner().deliver([&] { lathe->command(command); });
  });
  connect(m_panel, &LathePanel::touchOffRequested, this,
          [this](bool isX, double value) { touchOff(isX, value, false); });
  connect(m_panel, &LathePanel::mountRequested, this, &LatheView::mount);
  connect(m_panel, &LathePanel::folded, this, &LatheView::giveRoom);
  giveRoom();
  for (QWidget* each : m_panel->findChildren<QWidget*>()) {
    if (qobject_cast<HandwheelDial*>(each) || qobject_cast<QComboBox*>(each)) each->installEventFilter(this);
  }
}

// Gives the dock the height of its open sections, up to half of the window; the view has the rest. Applies after
// layout.
void LatheView::giveRoom() {
  QTimer::singleShot(0, m_dock, [this] {
    auto* const window = qobject_cast<QMainWindow*>(m_window.window);
    const int title = m_dock->height() - m_dock->widget()->height();
    window->resizeDocks({m_dock}, {std::min(m_panel->sizeHint().height() + title, window->height() / 2)}, Qt::Vertical);
  });
}

// The view has the keys of the slides, also after a click on a wheel or a tool. A rapid traverse ends with its key,
// whichever widget has the focus.
bool LatheView::eventFilter(QObject* watched, QEvent* event) {
  ManualLatheTool* const lathe = tool();
  if (!lathe) return QObject::eventFilter(watched, event);
  if (watched == &m_window.viewport) {
    const bool isReleased = event->type() == QEvent::KeyRelease && !static_cast<QKeyEvent*>(event)->isAutoRepeat();
    if (isReleased || event->type() == QEvent::FocusOut)
      m_window.tools.runner().deliver([lathe] { lathe->stopRapids(); });
  } else if (event->type() == QEvent::MouseButtonPress && qobject_cast<HandwheelDial*>(watched)) {
    m_window.viewport.setFocus(Qt::MouseFocusReason);
  } else if (event->type() == QEvent::FocusIn && qobject_cast<QComboBox*>(watched) &&
             static_cast<QFocusEvent*>(event)->reason() == Qt::PopupFocusReason) {
    m_window.viewport.setFocus(Qt::OtherFocusReason);
  }
  return QObject::eventFilter(watched, event);
}

// Away from any surface it would set a wrong zero: the user is asked first.
void LatheView::touchOff(bool isX, double value, bool isConfirmed) {
  ManualLatheTool* const lathe = tool();
  if (!lathe) return;
  const double gap = lathe->touchGap(isX);
  const bool isTouching = gap <= ManualLatheTool::kTouching;
  const bool isNewZero = !isX && value == 0.0 && lathe->touchesEnd();  // the work was faced
  const std::optional<double> measured = isTouching && !isNewZero ? lathe->touchedSize(isX) : std::nullopt;
  const bool isOther = measured && std::abs(*measured - value) > kOtherSize;
  if (isConfirmed || (isTouching && !isOther))
    return m_window.tools.runner().deliver([&] { lathe->touchOff(isX, value); });
  if (isOther) return askForSize(isX, value, *measured);
  const QString away = QLocale().toString(gap, 'f', 2);
  Message question{
      Message::Weight::Warning, tr("The tool does not touch the work"),
      isX ? tr("Its tip is %1 mm from the nearest surface, measured on the radius. X was not touched off.").arg(away)
          : tr("Its tip is %1 mm from the nearest face, measured along Z. Z was not touched off.").arg(away),
      isX ? tr("Turn a little of the bar, and touch off before the cross slide moves.")
          : tr("Touch or turn a face, and touch off before the carriage moves.")};
  question.actionText = tr("Touch off anyway");
  question.action = [view = QPointer(this), isX, value] {
    if (view) view->touchOff(isX, value, true);
  };
  question.otherText = tr("Cancel");
  question.other = [] {};
  question.isOver = [view = QPointer(this)] { return !view || !view->isOn(); };
  emit message(question);
}

// A slip of the keyboard gives a zero that all sizes to come are wrong by. The read-out stays until the turner decides.
void LatheView::askForSize(bool isX, double typed, double measured) {
  const QLocale locale;
  const QString badge = tool()->setup().showsDiameter ? QStringLiteral("⌀") : QStringLiteral("R");
  const QString entered = locale.toString(typed, 'f', 3), there = locale.toString(measured, 'f', 3);
  Message question{
      Message::Weight::Warning, isX ? tr("The work has another size there") : tr("The face is at another Z"),
      isX ? tr("%1 %2 mm was entered; where the tool touches, the work has %1 %3 mm. X was not touched off.")
                .arg(badge, entered, there)
          : tr("Z %1 mm was entered; from the zero of the work, the face that the tool touches is at Z %2 mm. "
               "Z was not touched off.")
                .arg(entered, there),
      tr("Measure again, and correct the number, or take it as it is. Undo takes it back.")};
  question.actionText = tr("Take %1").arg(locale.toString(typed, 'f', 3));
  question.action = [view = QPointer(this), isX, typed] {
    if (view) view->touchOff(isX, typed, true);
  };
  question.otherText = tr("Keep the read-out");
  question.other = [] {};
  question.isOver = [view = QPointer(this)] { return !view || !view->isOn(); };
  emit message(question);
}

void LatheView::mount(const QString& id) {
  ManualLatheTool* const lathe = tool();
  if (!lathe) return;
  std::optional<MountRefusal> refusal;
  m_window.tools.runner().deliver([&] { refusal = lathe->mount(lathe->moment()->machine.tool, id.toStdString()); });
  if (refusal)
    emit message({Message::Weight::Warning, tr("The tool was not mounted"),
                  QCoreApplication::translate("LathePart", sentenceOf(*refusal)), QString()});
}

void LatheView::follow() {
  const bool isRunning = isOn();
  if (isRunning) makeDock();
  const bool isOther = isRunning != m_refresh.isActive();
  if (m_dock && isOther) showDock(isRunning);
  if (isRunning && isOther) {
    m_refresh.start();
    // Runs after the dock is laid out.
    QTimer::singleShot(0, this, [this] {
      const ManualLatheTool* const lathe = tool();
      if (!lathe) return;
      const Left& left = m_left[m_document];
      if (m_panel) m_panel->begin(*lathe, lathe->isWhereLeft() ? left.rings : std::nullopt, left.touch);
      m_ringsOf = m_document;
      face(*lathe);
    });
  }
  if (!isRunning) {
    if (isOther) leave();
    m_refresh.stop();
  }
  showZero();
  if (std::exchange(m_isPushed, isRunning) != isRunning)
    m_window.spaceMouse.setTaker(isRunning ? [this](const Vec3& motion) { push(motion); }
                                           : SpaceMouseNavigation::Taker());
  const bool isTurning = isRunning || dynamic_cast<const TurnTool*>(m_window.tools.runner().tool());
  if (isTurning && !m_sounding.isActive()) m_sounding.start();
  if (!isTurning) m_sounding.stop();
  feel();
}

// A spindle that stops since another document is shown is a surprise. Said once that one is there, which shows it, too.
void LatheView::leave() {
  const auto left = m_left.find(m_document);
  if (left == m_left.end()) return;
  if (m_panel && m_ringsOf == m_document) {
    left->second.rings = m_panel->rings();
    left->second.touch = m_panel->touchValue();
  }
  const auto say = [this, document = m_document] {
    const auto its = m_left.find(document);
    if (its == m_left.end() || !its->second.machine->has_value() || !(*its->second.machine)->wasTurning) return;
    const DocumentTab* const current = m_window.tabs.current();
    if (current && &current->document == document) return;
    Message stopped{Message::Weight::Info, tr("The spindle was stopped"),
                    tr("The lathe of %1 stands still while another document is shown.").arg(document->name()),
                    tr("Its slides stay where they are, and its handwheels count on.")};
    stopped.about = document;
    stopped.isOver = [tabs = &m_window.tabs, document] {
      return tabs->current() && &tabs->current()->document == document;
    };
    emit message(stopped);
  };
  QTimer::singleShot(0, this, say);
}

// Runs only while something moves: the sound fades out by itself.
void LatheView::sound() {
  if (const ManualLatheTool* const lathe = tool()) {
    if (lathe->isLive()) m_quiet = 0;
    if (m_quiet++ * kSoundMs < kAfterwardsMs) m_window.sound.setState(soundOf(*lathe));
    return;
  }
  const auto* const turn = dynamic_cast<const TurnTool*>(m_window.tools.runner().tool());
  if (!turn) return;
  const MachineSoundState state = m_turning.next(*turn, 1e-3 * kSoundMs);
  if (turn->isLive()) m_window.sound.setState(state);
}

// Moves one slide at a time, as a hand at a wheel: a small motion along the other is unintended.
void LatheView::push(const Vec3& motion) {
  ManualLatheTool* const lathe = tool();
  if (!lathe) return;
  const bool isAlong = std::abs(motion.z()) >= std::abs(motion.x());
  const LatheCommand turn{LatheCommand::Kind::Turn, isAlong ? LatheAxis::Carriage : LatheAxis::Cross,
                          kPushed * (isAlong ? motion.z() : motion.x())};
  m_window.tools.runner().deliver([&] { lathe->command(turn); });
}

// The panel is as wide as the window: beside other docks there is no room for it.
void LatheView::showDock(bool isShown) {
  if (auto* const window = qobject_cast<QMainWindow*>(m_window.window))
    window->setCorner(Qt::BottomRightCorner, isShown ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea);
  m_dock->setVisible(isShown);
}

// Ends passes, and updates the moving parts.
void LatheView::refresh() {
  ManualLatheTool* const lathe = tool();
  if (!lathe || !m_panel) return;
  if (lathe->hasToCommit()) m_window.tools.runner().deliver([&] { lathe->endPass(); });
  if (!tool()) return;                                           // it failed
  const std::pair now(lathe->isLive(), lathe->moment()->isCut);  // the effect of undo depends on both
  if (std::exchange(m_was, now) != now) m_window.tools.refresh();
  m_panel->show(*lathe);
  showZero();
  sayUndone(*lathe);
}

// Shows the zero of Z of the read-out, once it was touched off.
void LatheView::showZero() {
  constexpr double kSize = 0.03, kStep = 1e-3;  // share of the length of the bar; mm
  const ManualLatheTool* const lathe = tool();
  std::pair<double, double> zero;
  if (lathe && lathe->isTouchedOff()[1]) {
    const double z = lathe->base() + lathe->moment()->tip.y() - lathe->readout().y();
    zero = {kStep * std::round(z / kStep), kSize * lathe->moment()->profile.length()};
  }
  const bool isFromBehind = isBehindLathe(m_window.viewport.camera());
  const bool isAsSeen = std::exchange(m_isFromBehind, isFromBehind) == isFromBehind;
  if (std::exchange(m_zero, zero) == zero && isAsSeen) return;
  m_zeroLayer->setLines(zero.second > 0.0 ? zeroSymbol(zero.first, zero.second, tr("Workpiece zero"), m_isFromBehind)
                                          : nullptr);
}

// A tool that jumps is a surprise.
void LatheView::sayUndone(const ManualLatheTool& lathe) {
  if (std::exchange(m_returns, lathe.returnCount()) >= lathe.returnCount()) return;
  emit message(
      {Message::Weight::Info, tr("The tool was moved"),
       tr("The restored material is where the tool was, so the tool was moved out of it."),
       lathe.moment()->machine.direction == 0 ? tr("The spindle stands still.") : tr("The spindle turns as before.")});
}

void LatheView::feel() {
  const ManualLatheTool* const lathe = tool();
  const std::shared_ptr<LatheChannel> channel = lathe ? lathe->channel() : nullptr;
  const std::shared_ptr<const LatheMaterial> material = lathe ? lathe->material() : nullptr;
  const bool isSame = std::exchange(m_felt, channel) == channel;
  if (std::exchange(m_feltMaterial, material) == material && isSame) return;
  if (!channel) return m_window.touch.setSource(kLatheSource, {}, false);
  const auto make = [channel, material, base = lathe->base()](const TouchContext& context) {
    LatheTouch touch;
    touch.stiffness = context.mapping.sceneStiffness(context.touch.stiffness);
    touch.plane = 0.5 * touch.stiffness;
    return std::make_unique<LatheForce>(channel, material, touch, base);
  };
  m_window.touch.setSource(kLatheSource, make, false);
}

}  // namespace handwheel
