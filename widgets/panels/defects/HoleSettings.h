// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/defects/MethodTable.h"

#include <QFrame>
#include <span>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace handwheel {

class NumberField;
enum class LengthUnit;

// The state of the fill preview.
struct PreviewState {
  enum class Kind { Off, Working, Ready, Failed };
  Kind kind = Kind::Off;
  std::size_t triangles = 0;                 // number of triangles of the patch; set if the preview is ready
  FillMethod method = FillMethod::Fair;      // the method of the patch
  Substitute substitute = Substitute::None;  // difference of the patch from the choice
  FillFailure failure = FillFailure::None;   // reason of the failure; set if the preview failed
  PatchComparison shape = {};                // comparison with the surroundings; set if the preview is ready
};

// The settings and buttons for filling the selected hole. Changes apply to the preview at once.
class HoleSettings : public QFrame {
  Q_OBJECT

 public:
  // Creates the buttons for these actions, which also exist in menus and have keys. thickenSheet, with its thickness,
  // and cutAndClose are shown only if they are possible.
  HoleSettings(QAction* fill, QAction* keepOpen, QAction* preview, QAction* thickenSheet, QAction* cutAndClose,
               QWidget* parent = nullptr);

  // Returns the available methods, in order.
  static std::span<const FillMethod> methods();
  FillMethod method() const;
  void setMethod(FillMethod method);
  void showLoop(const QString& name, const QString& detail, const QString& measures);
  void showPreview(const PreviewState& state);
  // Shows a sentence on the expected effect of another action, whose button is under the pointer. An empty text removes
  // it.
  void showOtherPreview(const QString& text);
  // Sets the thickness that a sheet will get, mm.
  void showThickness(double thickness, LengthUnit unit);
  // Returns true if the comparison of the methods is open, so that their statistics are needed.
  bool isComparing() const;
  void showTrials(const std::vector<MethodTrial>& trials);

 signals:
  void methodChanged(handwheel::FillMethod method);
  void compareRequested();
  void thicknessEdited(double thickness);  // mm
  void thickeningPointed(bool isPointed);  // the pointer or the focus comes to the button of thickenSheet, or leaves it

 private:
  QToolButton* compareButton();
  void keepRoomForOther(bool isKept);
  QWidget* thicknessRow();

  QLabel* m_name;
  QLabel* m_detail;
  QLabel* m_measures;
  QComboBox* m_method;
  QLabel* m_status;
  QLabel* m_otherStatus;
  MethodTable* m_trials;
  NumberField* m_thickness;
};

}  // namespace handwheel
