// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/tools/ToolHost.h"

#include "document/Document.h"
#include "theme/Theme.h"
#include "tools/UnfinishedGesture.h"
#include "viewport/Viewport.h"
#include "viewport/camera/CameraNavigation.h"
#include "viewport/surface/PartsLayer.h"
#include "window/tools/ToolKeys.h"
#include "window/tools/ToolPanel.h"
#include "window/tools/ToolReadout.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr int kPreviewFrameMs = 16;  // interval of a live preview
constexpr int kFramesToFigures = 8;  // interval in frames after which numbers that change by themselves are shown anew
constexpr std::string_view kLeaves = "done";  // effect of Esc in a tool that has nothing to revert

PointerButton buttonOf(Qt::MouseButton button) {
  if (button == Qt::LeftButton) return PointerButton::First;
  return button == Qt::RightButton ? PointerButton::Second : PointerButton::None;
}

// None for what is the camera's in any case.
std::optional<PointerEvent> eventOf(const PointerInput& input, const ViewRay& ray, const CameraState& camera) {
  PointerEvent event;
  event.focus = ray.eye ? camera.eyeDistance() : 0.0;
  event.ray = {ray.origin, ray.direction};
  event.eye = ray.eye;
  event.pixel = ray.pixel;
  event.time = input.time;
  event.pressure = input.pressure;
  event.button = buttonOf(input.button);
  event.modifiers = {input.modifiers.testFlag(Qt::ShiftModifier), input.modifiers.testFlag(Qt::ControlModifier),
                     input.modifiers.testFlag(Qt::AltModifier)};
  switch (input.kind) {
    case PointerInput::Kind::Move:
      event.kind = input.held & Qt::LeftButton ? PointerEvent::Kind::Drag : PointerEvent::Kind::Hover;
      if (event.kind == PointerEvent::Kind::Drag) event.button = PointerButton::First;
      return event;
    case PointerInput::Kind::Press:
      event.kind = PointerEvent::Kind::Press;
      break;
    case PointerInput::Kind::Release:
      event.kind = PointerEvent::Kind::Release;
      break;
    case PointerInput::Kind::DoubleClick:
      event.kind = PointerEvent::Kind::DoubleClick;
      break;
    case PointerInput::Kind::Leave:
      event.kind = PointerEvent::Kind::Leave;
      return event;
    case PointerInput::Kind::Click:
    case PointerInput::Kind::Wheel:
      return {};
  }
  return event.button == PointerButton::First ? std::optional(event) : std::nullopt;
}

// Proposals of a tool are distinguished from existing parts by their colour.
void tint(std::vector<DisplayPart>& parts) {
  const QColor accent = themeColours(currentTheme()).accent;
  for (DisplayPart& part : parts) part.colour = {accent.redF(), accent.greenF(), accent.blueF()};
}

// Returns true for a key that a widget with the focus works with: those that move in it, and Space where it presses or
// marks something. All others that a widget needs are claimed by itself.
bool isOfWidget(const QWidget& focus, const QKeyEvent& event) {
  constexpr int kMoving[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,    Qt::Key_Home,
                             Qt::Key_End,  Qt::Key_Tab,   Qt::Key_PageUp, Qt::Key_PageDown};
  if (std::find(std::begin(kMoving), std::end(kMoving), event.key()) != std::end(kMoving)) return true;
  if (event.key() != Qt::Key_Space) return false;
  const auto* const list = qobject_cast<const QAbstractItemView*>(&focus);
  return !list || list->currentIndex().flags().testFlag(Qt::ItemIsUserCheckable);
}

QString translated(const char* context, const std::string& text) {
  return QCoreApplication::translate(context, text.c_str());
}

}  // namespace

ToolHost::ToolHost(Viewport& viewport, ToolPanel& panel, ServiceRegistry& needs, QObject* parent)
    : QObject(parent),
      m_viewport(viewport),
      m_proposed(std::make_shared<PartsLayer>(PartsLayer::Role::Proposed)),
      m_panel(panel),
      m_readout(new ToolReadout(&viewport)),
      m_label(new ToolReadout(&viewport)),
      m_keys(*new ToolKeys(viewport, this)),
      m_needs(needs) {
  m_label->setObjectName(QStringLiteral("toolLabel"));
  m_viewport.addLayer(m_proposed);
  m_viewport.installEventFilter(this);
  m_viewport.window()->installEventFilter(this);
  m_viewport.setPointerSink([this](const PointerInput& input) { return take(input); });
  connect(&m_panel.settings(), &PropertyList::edited, this,
          [this](const std::string& id, const PropertyValue& value, bool) {
            if (const Tool* tool = m_runner.tool()) choose(tool->id(), id, value);
          });
  connect(&m_panel, &ToolPanel::triggered, this, [this](const std::string& action) { perform(action); });
  connect(&m_keys, &ToolKeys::triggered, this, [this](const std::string& action) { perform(action); });
  connect(&m_keys, &ToolKeys::changed, this, [this] {
    showActions();
    emit updated();
  });
  connect(&m_runner, &ToolRunner::updated, this, [this] { m_isMoving ? showSoon() : show(); });
  connect(&m_runner, &ToolRunner::ended, this, &ToolHost::showNothing);
  connect(&m_viewport, &Viewport::cameraChanged, this, [this] {
    if (m_label->isVisible()) showSoon();
  });
  m_frames.setInterval(kPreviewFrameMs);
  connect(&m_frames, &QTimer::timeout, this, [this] {
    m_runner.resume();
    if (!m_runner.tool()) return;
    if (++m_frame % kFramesToFigures == 0) return show();
    showShapes(m_runner.tool()->preview());
  });
}

ToolHost::~ToolHost() {
  m_runner.disconnect(this);
  m_viewport.setPointerSink({});
  m_viewport.removeLayer(*m_proposed);
}

void ToolHost::start(std::unique_ptr<Tool> tool, Document& document) {
  m_needed.clear();
  for (const std::string& service : tool->needs()) m_needed.push_back(m_needs.need(service));
  if (tool->remembersSettings()) {
    for (const auto& [id, value] : m_chosen[tool->id()]) tool->setSetting(id, value);
    for (const auto& [id, value] : m_chosenOfDocument[{document.file().id, tool->id()}]) tool->setSetting(id, value);
  }
  m_panel.setActions({}, {});  // those of another tool have nothing to do with its own
  m_runner.start(std::move(tool), document);
  show();
}

bool ToolHost::isUnderWay(const Document& document) const {
  const auto* const gesture = dynamic_cast<const UnfinishedGesture*>(m_runner.tool());
  return gesture && m_runner.document() == &document && !gesture->underWay().isEmpty();
}

// The runner returns its tool as const, for all who only read it; the tool is called through deliver().
SnapshotPointer ToolHost::valueWithGesture(const Document& document) {
  auto* const gesture = const_cast<UnfinishedGesture*>(dynamic_cast<const UnfinishedGesture*>(m_runner.tool()));
  if (!gesture || m_runner.document() != &document) return nullptr;
  SnapshotPointer value;
  m_runner.deliver([&] { value = gesture->withGesture(); });
  return value;
}

void ToolHost::setVisible(bool visible) {
  if (visible == m_isVisible) return;
  m_isVisible = visible;
  show();
}

void ToolHost::choose(const std::string& tool, const std::string& setting, const PropertyValue& value) {
  const bool isRunning = m_runner.tool() && m_runner.tool()->id() == tool;
  if (isRunning && m_runner.tool()->isOfDocument(setting))
    m_chosenOfDocument[{m_runner.document()->file().id, tool}][setting] = value;
  else
    m_chosen[tool][setting] = value;
  if (isRunning) m_runner.setSetting(setting, value);
}

// A hover is never kept from the view, which tells the lists what is under the cursor.
bool ToolHost::take(const PointerInput& input) {
  const ViewRay ray = m_viewport.rayAt(input.position);
  const auto tip = m_mouseDevice ? m_mouseDevice(input, ray) : std::nullopt;
  const bool isDepth = tip && input.kind == PointerInput::Kind::Wheel && !input.modifiers.testFlag(Qt::ControlModifier);
  if (!m_runner.tool()) return isDepth;
  if (input.kind == PointerInput::Kind::Click && input.button == Qt::RightButton) {
    if (m_menu && m_menu(input.position)) return true;
    return perform("revert") != ToolReply::Ignored;
  }
  PointerInput read = input;
  if (isDepth) read.kind = PointerInput::Kind::Move;
  auto event = eventOf(read, ray, m_viewport.camera());
  if (!event) return false;
  event->device = tip;
  const QScopedValueRollback moving(m_isMoving, read.kind == PointerInput::Kind::Move);
  const bool used = m_runner.pointer(*event) != ToolReply::Ignored;
  showValues(input, used ? event->kind : PointerEvent::Kind::Leave);
  return isDepth || (used && event->kind != PointerEvent::Kind::Hover && event->kind != PointerEvent::Kind::Leave);
}

// Most actions end what is dragged: the next move shows its numbers again if not.
ToolReply ToolHost::perform(std::string_view action) {
  m_readout->hide();
  return m_runner.perform(action);
}

// Dragged values are shown beside the cursor.
void ToolHost::showValues(const PointerInput& input, PointerEvent::Kind kind) {
  const Tool* tool = m_runner.tool();
  if (!tool || !m_runner.document() || kind != PointerEvent::Kind::Drag) return m_readout->hide();
  m_readout->show(tool->settings(), m_runner.document()->displayUnit(), input.position.toPoint());
}

std::vector<Hint> ToolHost::hints() const {
  std::vector<Hint> hints;
  const Tool* tool = m_runner.tool();
  if (!tool) return hints;
  for (const ToolAction& action : tool->actions()) {
    const bool isGesture = action.id.empty() && action.command.empty();
    const QString input = isGesture ? translated("ToolInput", action.input) : m_keys.text(*tool, action);
    if (!action.enabled || input.isEmpty()) continue;  // a button in the panel says it
    const QString effect = translated("Tool", action.effect);
    if (!hints.empty() && hints.back().effect == effect) {
      hints.back().input += QStringLiteral(" / ") + input;
    } else {
      hints.push_back({input, effect});
    }
  }
  if (m_isMouseDevice()) {
    hints.push_back({tr("Wheel"), tr("move the tip in and out")});
    hints.push_back({tr("Ctrl+wheel"), tr("zoom")});
  }
  return hints;
}

// A key that nobody between the focus and the window needs comes to the window at last; and to a dock, which may float.
bool ToolHost::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) return claimKey(*static_cast<QKeyEvent*>(event));
  if (event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
  const bool isClaimed = watched == m_claimed;
  if (isClaimed) unclaim();
  return (isClaimed || watched == &m_viewport) && takeKey(*static_cast<QKeyEvent*>(event));
}

// Qt asks before it looks for a command of the window with this key: what is accepted then comes as a press, to the
// widget with the focus, which might do something of its own with it.
bool ToolHost::claimKey(QKeyEvent& event) {
  unclaim();
  const Tool* const tool = m_runner.tool();
  QWidget* const focus = QApplication::focusWidget();
  if (!tool || !focus || (focus != &m_viewport && isOfWidget(*focus, event))) return false;
  const auto action = m_keys.actionFor(*tool, event);
  if (action ? !action->command.empty() : !m_keys.isReserved(*tool, event)) return false;
  event.accept();
  m_claimed = focus;
  if (!isWatched(*focus)) focus->installEventFilter(this);
  return true;
}

void ToolHost::unclaim() {
  if (m_claimed && !isWatched(*m_claimed)) m_claimed->removeEventFilter(this);
  m_claimed = nullptr;
}

// The view, the window and its docks are watched all the time.
bool ToolHost::isWatched(const QWidget& widget) const {
  return &widget == &m_viewport || widget.isWindow() || qobject_cast<const QDockWidget*>(&widget);
}

bool ToolHost::takeKey(QKeyEvent& event) {
  const auto action = m_runner.tool() ? m_keys.actionFor(*m_runner.tool(), event) : std::nullopt;
  const bool isIdle = !action || action->effect == kLeaves;
  if (event.key() == Qt::Key_Escape && isIdle && m_escape()) return true;
  return action && perform(action->id) != ToolReply::Ignored;
}

// A tool receives every position of the mouse; its display is drawn once for all positions that wait.
void ToolHost::showSoon() {
  if (std::exchange(m_isShowDue, true)) return;
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (m_isShowDue) show();
      },
      Qt::QueuedConnection);
}

void ToolHost::show() {
  m_isShowDue = false;
  const Tool* tool = m_runner.tool();
  if (!tool) return showNothing();
  showShapes(tool->preview());
  if (tool->isLive() != m_frames.isActive()) tool->isLive() ? m_frames.start() : m_frames.stop();
  if (m_runner.document()) m_panel.settings().setLengthUnit(m_runner.document()->displayUnit());
  m_panel.settings().setProperties(tool->settings());
  showActions();
  emit updated();
}

// Parts of all kinds are shown here, the rest by the kind of the document.
void ToolHost::showShapes(ToolPreview preview) {
  emit previewed(preview);
  if (!m_isVisible) preview = {};
  tint(preview.parts);
  m_proposed->setParts(preview.parts);
  m_viewport.setPolylines(std::move(preview.lines));
  m_viewport.setBrush(preview.circle ? std::optional(BrushCircle{preview.circle->first, preview.circle->second})
                                     : std::nullopt);
  showLabel(preview.label);
}

void ToolHost::showLabel(const std::optional<ToolLabel>& label) {
  const CameraNavigation navigation(m_viewport.camera(), {m_viewport.width(), m_viewport.height()});
  if (!label || !m_runner.document() || !navigation.isBeforeEye(label->position)) return m_label->hide();
  const Vec2 screen = navigation.toScreen(label->position);
  const QPointF at(screen.x(), screen.y());
  if (!QRectF(m_viewport.rect()).contains(at)) return m_label->hide();
  m_label->show(*label, m_runner.document()->displayUnit(), at.toPoint());
}

void ToolHost::showActions() {
  const Tool* tool = m_runner.tool();
  const std::vector<ToolAction> actions = tool ? tool->actions() : std::vector<ToolAction>();
  m_keys.follow(tool, actions);
  m_panel.setActions(actions, [this, tool](const ToolAction& action) { return m_keys.text(*tool, action); });
}

void ToolHost::showNothing() {
  m_isShowDue = false;
  m_frames.stop();
  m_needed.clear();
  m_readout->hide();
  showShapes({});
  m_panel.settings().setProperties({});
  showActions();
  emit updated();
}

}  // namespace handwheel
