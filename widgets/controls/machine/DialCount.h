// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// The place of a slide as its dial counts it. In whole turns and divisions from the zero that was set. Plain values,
// any thread; mm. What is not finite changes nothing.
class DialCount {
 public:
  static constexpr int kMostDivisions = 1000;

  void setValue(double mm);
  void setZero(double mm);
  void setDivisions(int perTurn, double mmPerDivision);

  double value() const { return m_value; }
  double zero() const { return m_zero; }
  double reading() const { return m_value - m_zero; }  // mm
  int perTurn() const { return m_perTurn; }
  double mmPerDivision() const { return m_mmPerDivision; }

  // The reading in divisions. Within a thousandth of a division of a tenth it is that tenth.
  double divisions() const;
  double turns() const;         // whole ones, rounded down
  double restOfTurn() const;    // divisions, 0 to below perTurn()
  double wheelDegrees() const;  // by which the wheel is turned clockwise, 0 to below 360, whatever the zero

  // The value after some tenths of a division. From a place on a tenth it comes to a place on a tenth.
  double after(double tenths) const;

 private:
  double m_value = 0.0;
  double m_zero = 0.0;
  int m_perTurn = 100;
  double m_mmPerDivision = 0.05;
};

}  // namespace handwheel
