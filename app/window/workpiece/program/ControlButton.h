// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "machining/program/ProgramSetup.h"

#include <QToolButton>
#include <array>

class QAction;

namespace handwheel {

// A button with the settings of a control that a program does not tell. They are the unit of numbers without a decimal
// point and the switches of the block skips. It must be used on the window thread.
class ControlButton : public QToolButton {
  Q_OBJECT

 public:
  explicit ControlButton(QWidget* parent = nullptr);

  // Offers the settings that a dialect has. The others are shown as disabled, and have no effect.
  void setDialect(ProgramDialect dialect);
  void applyTo(ProgramSetup& setup) const;

 signals:
  void changed();  // emitted when the user changes a setting

 private:
  static constexpr std::size_t kSkips = 9;

  QAction* m_increments;
  std::array<QAction*, kSkips> m_skips{};
};

}  // namespace handwheel
