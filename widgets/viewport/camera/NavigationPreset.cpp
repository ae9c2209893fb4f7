// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera/NavigationPreset.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

using enum NavigationGesture;
constexpr auto kLeft = Qt::LeftButton, kMiddle = Qt::MiddleButton, kRight = Qt::RightButton;
constexpr auto kNoKey = Qt::NoModifier, kShift = Qt::ShiftModifier, kCtrl = Qt::ControlModifier, kAlt = Qt::AltModifier;

// The first binding of a gesture is the one that the hint bar names.
constexpr NavigationBinding kHandwheel[] = {
    {kMiddle, kNoKey, Orbit}, {kMiddle, kShift, Pan},       {kMiddle, kCtrl, Zoom},
    {kRight, kNoKey, Pan},    {kLeft, kNoKey, Orbit, true}, {kLeft, kAlt, Orbit},
};
constexpr NavigationBinding kBlender[] = {
    {kMiddle, kNoKey, Orbit},
    {kMiddle, kShift, Pan},
    {kMiddle, kCtrl, Zoom},
};
// Bindings of its style "CAD".
constexpr NavigationBinding kFreeCad[] = {
    {kMiddle | kLeft, kNoKey, Orbit},
    {kMiddle | kRight, kNoKey, Orbit},
    {kRight, kShift, Orbit},
    {kMiddle, kNoKey, Pan},
    {kRight, kCtrl, Pan},
    {kRight, kCtrl | kShift, Zoom},
};
constexpr NavigationBinding kSolidWorks[] = {
    {kMiddle, kNoKey, Orbit},
    {kMiddle, kCtrl, Pan},
    {kMiddle, kShift, Zoom},
};
// Many desktops keep Alt and the left button for moving windows: so the right button can do everything, too.
constexpr NavigationBinding kLaptop[] = {
    {kRight, kNoKey, Orbit}, {kRight, kShift, Pan},       {kRight, kCtrl, Zoom},       {kLeft, kNoKey, Orbit, true},
    {kLeft, kAlt, Orbit},    {kLeft, kAlt | kShift, Pan}, {kLeft, kAlt | kCtrl, Zoom},
};

struct Preset {
  const char* id;
  const char* name;
  std::span<const NavigationBinding> bindings;
  bool awayEnlarges;
};

const Preset& presetFor(NavigationPreset preset) {
  static constexpr Preset kPresets[] = {
      {"handwheel", QT_TRANSLATE_NOOP("Navigation", "Handwheel"), kHandwheel, true},
      {"blender", QT_TRANSLATE_NOOP("Navigation", "Blender"), kBlender, true},
      {"freecad", QT_TRANSLATE_NOOP("Navigation", "FreeCAD"), kFreeCad, true},
      {"solidworks", QT_TRANSLATE_NOOP("Navigation", "SolidWorks"), kSolidWorks, false},
      {"laptop", QT_TRANSLATE_NOOP("Navigation", "Laptop without a middle button"), kLaptop, true},
  };
  static_assert(std::size(kPresets) == kNavigationPresets.size());
  return kPresets[static_cast<std::size_t>(preset)];
}

QString text(const char* source) {
  return QCoreApplication::translate("Navigation", source);
}

QString inputText(const NavigationBinding& binding) {
  QString keys;
  if (binding.modifiers & kCtrl) keys += text(QT_TRANSLATE_NOOP("Navigation", "Ctrl+"));
  if (binding.modifiers & kAlt) keys += text(QT_TRANSLATE_NOOP("Navigation", "Alt+"));
  if (binding.modifiers & kShift) keys += text(QT_TRANSLATE_NOOP("Navigation", "Shift+"));
  QStringList buttons;
  if (binding.buttons & kLeft) buttons += text(QT_TRANSLATE_NOOP("Navigation", "left"));
  if (binding.buttons & kMiddle) buttons += text(QT_TRANSLATE_NOOP("Navigation", "middle"));
  if (binding.buttons & kRight) buttons += text(QT_TRANSLATE_NOOP("Navigation", "right"));
  QString all = keys + buttons.join(QLatin1Char('+'));
  all[0] = all[0].toUpper();
  return all;
}

QString effectText(NavigationGesture gesture) {
  switch (gesture) {
    case Orbit:
      return text(QT_TRANSLATE_NOOP("Navigation", "orbit"));
    case Pan:
      return text(QT_TRANSLATE_NOOP("Navigation", "pan"));
    case Zoom:
      return text(QT_TRANSLATE_NOOP("Navigation", "zoom"));
    case None:
      break;
  }
  return {};
}

}  // namespace

std::span<const NavigationBinding> bindingsOf(NavigationPreset preset) {
  return presetFor(preset).bindings;
}

NavigationGesture gestureFor(NavigationPreset preset, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers,
                             bool onBackground) {
  const Qt::KeyboardModifiers keys = modifiers & (kShift | kCtrl | kAlt);
  for (const NavigationBinding& b : bindingsOf(preset)) {
    if (b.buttons == buttons && b.modifiers == keys && (onBackground || !b.onBackground)) return b.gesture;
  }
  return None;
}

bool wheelAwayEnlarges(NavigationPreset preset) {
  return presetFor(preset).awayEnlarges;
}

QString idOf(NavigationPreset preset) {
  return QString::fromLatin1(presetFor(preset).id);
}

NavigationPreset presetOf(const QString& id) {
  for (const NavigationPreset preset : kNavigationPresets) {
    if (idOf(preset) == id) return preset;
  }
  return NavigationPreset::Handwheel;
}

QString nameOf(NavigationPreset preset) {
  return text(presetFor(preset).name);
}

std::vector<std::pair<QString, QString>> navigationHints(NavigationPreset preset) {
  std::vector<std::pair<QString, QString>> hints;
  for (const NavigationGesture gesture : {Orbit, Pan}) {
    const auto bindings = bindingsOf(preset);
    const auto first = std::find_if(bindings.begin(), bindings.end(), [&](const NavigationBinding& b) {
      return b.gesture == gesture && !b.onBackground;
    });
    if (first != bindings.end()) hints.emplace_back(inputText(*first), effectText(gesture));
  }
  hints.emplace_back(text(QT_TRANSLATE_NOOP("Navigation", "Wheel")), effectText(Zoom));
  return hints;
}

}  // namespace handwheel
