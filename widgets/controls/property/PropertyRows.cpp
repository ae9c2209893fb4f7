// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/property/PropertyRows.h"

#include "controls/NumberField.h"
#include "controls/QuantityText.h"

#include <QAbstractItemView>
#include <QBoxLayout>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr int kSliderSteps = 1000;
constexpr double kNearLimit = 0.05;  // share of the range: values nearer to a limit are shown there
constexpr int kMostListed = 8;       // rows of two lines, before a list scrolls
// Limits on the width of a box, in letters. It is that of its longest choice, in wide letters, of which three are as
// wide as four others.
constexpr int kFewestLetters = 6;
constexpr int kMostLetters = 15;
constexpr qsizetype kMostBeside = 20;  // letters of a choice beside its label
constexpr int kListMargin = 24;        // pixels, for frame and scroll bar
constexpr double kMostCount = 1e15;    // whole numbers beyond have digits that a double does not

// A slider that ignores the wheel, which would otherwise change it instead of scrolling the form.
class FormSlider final : public QSlider {
 public:
  using QSlider::QSlider;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus()) return QSlider::wheelEvent(event);
    event->ignore();
  }
};
// A combo box that ignores the wheel also with the focus, which it keeps after a choice: scrolling the form would
// choose anew.
class FormBox final : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

// Returns a value as the type that the row is made for. Another type would be a bug of the document; it shows as zero
// or nothing.
template <class T>
T valueAs(const Property& property) {
  const T* value = std::get_if<T>(&property.value);
  return value ? *value : T();
}

int choiceOf(const Property& property) {
  const double index = valueAs<double>(property);
  return index >= 0.0 && index < static_cast<double>(property.choices.size()) ? static_cast<int>(index) : -1;
}

// Returns true for counts, which are grouped as in all sentences: "33,992". A field has no groups, for its comma could
// be a decimal one.
bool isCount(const Property& property) {
  const auto value = valueAs<double>(property);
  return property.quantity == Quantity::Number && property.prefix.empty() && std::abs(value) < kMostCount &&
         value == std::floor(value);
}

QString plainText(const Property& property) {
  return QString::fromStdString(valueAs<std::string>(property));
}

}  // namespace

NumberRow::NumberRow(QWidget* parent)
    : PropertyRow(parent),
      m_field(new NumberField(this)),
      m_travel(new QWidget(this)),
      m_slider(new FormSlider(Qt::Horizontal, m_travel)),
      m_lower(new QLabel(m_travel)),
      m_upper(new QLabel(m_travel)) {
  m_slider->setObjectName(QStringLiteral("propertySlider"));
  m_slider->setRange(0, kSliderSteps);
  m_slider->setSingleStep(kSliderSteps / 100);
  m_slider->setPageStep(kSliderSteps / 10);
  m_slider->setFocusPolicy(Qt::StrongFocus);
  m_lower->setObjectName(QStringLiteral("propertyLower"));
  m_upper->setObjectName(QStringLiteral("propertyUpper"));
  for (QLabel* limit : {m_lower, m_upper}) limit->setProperty("muted", true);
  auto* line = new QHBoxLayout(m_travel);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  line->addWidget(m_lower);
  line->addWidget(m_slider, 1);
  line->addWidget(m_upper);
  arrange(m_field, true, m_travel);
  connect(m_field, &NumberField::valueEdited, this,
          [this](double value, bool stillDragging) { emit edited(value, stillDragging); });
  connect(m_field, &NumberField::valueTyped, this, [this](double value) { emit typed(value); });
  connect(m_slider, &QSlider::valueChanged, this, &NumberRow::slide);
  connect(m_slider, &QSlider::sliderReleased, this, [this] {
    if (std::exchange(m_slid, false)) slide(m_slider->value());
  });
}

void NumberRow::showValue(const Property& property, LengthUnit unit) {
  const auto value = valueAs<double>(property);
  m_field->setQuantity(property.quantity, unit);
  m_field->setPrefix(QString::fromStdString(property.prefix));
  m_field->setRange(property.least, property.largest);
  m_field->setValue(value);
  m_least = property.least;
  m_largest = property.largest;
  const bool bounded = std::isfinite(m_least) && std::isfinite(m_largest) && m_least < m_largest;
  m_travel->setVisible(property.continuous && bounded);
  m_lower->setText(quantityText(m_least, property.quantity, unit, locale()));
  m_upper->setText(quantityText(m_largest, property.quantity, unit, locale()));
  if (!bounded || m_slider->isSliderDown() || !std::isfinite(value)) return;
  const QSignalBlocker quiet(m_slider);
  const double share = std::clamp((value - m_least) / (m_largest - m_least), 0.0, 1.0);
  showNearness(share);
  m_slider->setValue(static_cast<int>(std::lround(share * kSliderSteps)));
}

// Highlights the limit that the value is near to.
void NumberRow::showNearness(double share) {
  const std::pair<QLabel*, bool> limits[] = {{m_lower, share < kNearLimit}, {m_upper, share > 1.0 - kNearLimit}};
  for (const auto& [label, isNear] : limits) {
    label->setProperty("muted", !isNear);
    markBad(*label, isNear);
  }
}

void NumberRow::setLabel(const QString& label) {
  m_field->setLabel(label);
  m_slider->setAccessibleName(label);
}

// The value is a weighted mean, so that both ends are met exactly.
void NumberRow::slide(int position) {
  const double share = static_cast<double>(position) / kSliderSteps;
  const double value = (1.0 - share) * m_least + share * m_largest;
  m_field->setValue(value);
  m_slid = m_slider->isSliderDown();
  emit edited(value, m_slid);
}

SwitchRow::SwitchRow(QWidget* parent) : PropertyRow(parent), m_box(new QCheckBox(this)) {
  m_box->setObjectName(QStringLiteral("propertySwitch"));
  arrange(m_box, false);
  connect(m_box, &QCheckBox::clicked, this, [this](bool checked) { emit edited(checked, false); });
}

void SwitchRow::showValue(const Property& property, LengthUnit) {
  m_box->setChecked(valueAs<bool>(property));
}

void SwitchRow::setLabel(const QString& label) {
  m_box->setText(label);
}

TextRow::TextRow(QWidget* parent) : TextRow(parent, nullptr) {}

TextRow::TextRow(QWidget* parent, QWidget* beside) : PropertyRow(parent), m_line(new QLineEdit(this)) {
  m_line->setObjectName(QStringLiteral("propertyText"));
  m_line->installEventFilter(this);
  arrange(m_line, true, nullptr, beside);
  connect(m_line, &QLineEdit::textEdited, this, &TextRow::forgetRefusal);
  connect(m_line, &QLineEdit::editingFinished, this, [this] {
    if (!m_line->isModified()) return;
    m_line->setModified(false);
    forgetRefusal();
    const QString text = m_line->text();
    emit edited((m_isNumbers ? withPoints(text, locale()) : text).toStdString(), false);
  });
}

QString TextRow::shown(const QString& value) const {
  return m_isNumbers ? withLocalNumbers(value, locale()) : value;
}

// Refused text is out of date when the value has changed and nobody is typing any more.
void TextRow::showValue(const Property& property, LengthUnit) {
  m_isNumbers = property.isNumbers;
  const QString value = shown(plainText(property));
  if (std::exchange(m_value, value) != value && !m_line->hasFocus()) {
    m_line->setModified(false);
    forgetRefusal();
  }
  if (m_line->isModified() || m_line->text() == m_value) return;
  m_line->setText(m_value);
  constexpr qsizetype kLong = 20;  // letters; such a text is read from its beginning, and whole in the tool tip
  const bool isLong = m_value.size() > kLong;
  if (isLong && !m_line->hasFocus()) m_line->setCursorPosition(0);
  m_line->setToolTip(isLong ? QStringLiteral("<p>%1</p>").arg(m_value.toHtmlEscaped()) : QString());
}

void TextRow::setLabel(const QString& label) {
  m_line->setAccessibleName(label);
}

bool TextRow::keep(const PropertyValue& entered) {
  m_line->setText(shown(QString::fromStdString(std::get<std::string>(entered))));
  m_line->setModified(true);
  return true;
}

bool TextRow::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (watched != m_line || !isKey || !m_line->isModified() || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return PropertyRow::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  m_line->setModified(false);
  forgetRefusal();
  m_line->setText(m_value);
  m_line->selectAll();
  return true;
}

SuggestedTextRow::SuggestedTextRow(QWidget* parent) : SuggestedTextRow(parent, new QToolButton) {}

SuggestedTextRow::SuggestedTextRow(QWidget* parent, QToolButton* button)
    : TextRow(parent, button), m_button(button), m_list(new QMenu(button)) {
  m_button->setObjectName(QStringLiteral("propertySuggestions"));
  m_button->setArrowType(Qt::DownArrow);
  m_button->setToolTip(tr("Choose from a list"));
  m_button->setPopupMode(QToolButton::InstantPopup);
  m_button->setMenu(m_list);
}

void SuggestedTextRow::showValue(const Property& property, LengthUnit unit) {
  TextRow::showValue(property, unit);
  QStringList texts;
  for (const std::string& choice : property.choices) texts << translated(choice);
  if (std::exchange(m_texts, texts) == texts) return;
  m_list->clear();
  for (const QString& text : texts)
    m_list->addAction(text, this, [this, text] { emit edited(text.toStdString(), false); });
}

void SuggestedTextRow::setLabel(const QString& label) {
  TextRow::setLabel(label);
  m_button->setAccessibleName(tr("Choose: %1").arg(label));
}

LongTextRow::LongTextRow(QWidget* parent)
    : PropertyRow(parent), m_heading(new QLabel(this)), m_field(new QPlainTextEdit(this)) {
  constexpr int kLines = 5;  // lines visible at once
  m_field->setObjectName(QStringLiteral("propertyLongText"));
  m_field->setTabChangesFocus(true);
  m_field->setFixedHeight(kLines * m_field->fontMetrics().lineSpacing() + 12);
  m_field->setToolTip(tr("Ctrl+Return, or leaving the field, takes the text; Esc gives it back as it was."));
  m_field->installEventFilter(this);
  m_heading->setBuddy(m_field);
  auto* both = new QWidget(this);
  auto* column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(m_heading);
  column->addWidget(m_field);
  arrange(both, false);
}

// The same as in TextRow.
void LongTextRow::showValue(const Property& property, LengthUnit) {
  const QString value = plainText(property);
  if (std::exchange(m_value, value) != value && !m_field->hasFocus()) {
    m_field->document()->setModified(false);
    forgetRefusal();
  }
  if (m_field->document()->isModified() || m_field->toPlainText() == m_value) return;
  restore();
}

void LongTextRow::setLabel(const QString& label) {
  m_heading->setText(label);
  m_field->setAccessibleName(label);
}

bool LongTextRow::keep(const PropertyValue& entered) {
  m_field->setPlainText(QString::fromStdString(std::get<std::string>(entered)));
  m_field->document()->setModified(true);
  return true;
}

void LongTextRow::take() {
  if (!m_field->document()->isModified()) return;
  m_field->document()->setModified(false);
  forgetRefusal();
  emit edited(m_field->toPlainText().toStdString(), false);
}

void LongTextRow::restore() {
  m_field->setPlainText(m_value);
  m_field->document()->setModified(false);
}

bool LongTextRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) take();
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!isKey) return PropertyRow::eventFilter(watched, event);
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool isReturn = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
  const bool isTaken = isReturn && key.modifiers().testFlag(Qt::ControlModifier);
  const bool isGivenBack = key.key() == Qt::Key_Escape && m_field->document()->isModified();
  if (!isTaken && !isGivenBack) return PropertyRow::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  if (isTaken) return take(), true;
  forgetRefusal();
  restore();
  return true;
}

ColourRow::ColourRow(QWidget* parent) : ColourRow(parent, new QToolButton) {}

ColourRow::ColourRow(QWidget* parent, QToolButton* button) : TextRow(parent, button), m_button(button) {
  m_button->setObjectName(QStringLiteral("propertyColour"));
  m_button->setToolTip(tr("Choose a colour…"));
  connect(m_button, &QToolButton::clicked, this, &ColourRow::choose);
}

void ColourRow::showValue(const Property& property, LengthUnit unit) {
  TextRow::showValue(property, unit);
  m_colour = QColor(plainText(property));
  QPixmap swatch(m_button->iconSize());
  swatch.fill(m_colour);
  m_button->setIcon(swatch);
}

void ColourRow::setLabel(const QString& label) {
  TextRow::setLabel(label);
  m_button->setAccessibleName(tr("Choose: %1").arg(label));
}

void ColourRow::choose() {
  auto* dialog = new QColorDialog(m_colour, window());
  dialog->setObjectName(QStringLiteral("colourDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QColorDialog::colorSelected, this,
          [this](const QColor& colour) { emit edited(colour.name().toStdString(), false); });
  dialog->open();
}

ChoiceRow::ChoiceRow(QWidget* parent) : PropertyRow(parent), m_box(new FormBox(this)) {
  m_box->setFocusPolicy(Qt::StrongFocus);
  m_box->setObjectName(QStringLiteral("propertyChoice"));
  m_box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_box->setMinimumContentsLength(kFewestLetters);
  arrange(m_box);
  connect(m_box, &QComboBox::activated, this, [this](int index) { emit edited(static_cast<double>(index), false); });
}

void ChoiceRow::showValue(const Property& property, LengthUnit) {
  QStringList choices;
  for (const std::string& choice : property.choices) choices << translated(choice);
  QStringList shown;
  for (int i = 0; i < m_box->count(); ++i) shown << m_box->itemText(i);
  if (shown != choices) {
    qsizetype longest = 0;
    for (const QString& choice : choices) longest = std::max(longest, choice.size());
    m_box->setMinimumContentsLength(
        static_cast<int>(std::clamp(longest * 3 / 4, qsizetype{kFewestLetters}, qsizetype{kMostLetters})));
    m_box->clear();
    m_box->addItems(choices);
    // Long names, such as those of materials, have all of the width, below the label; the list is as wide as they are.
    const bool isBelow = longest > kMostBeside;
    auto* const line = static_cast<QBoxLayout*>(layout()->itemAt(0)->layout());
    line->setDirection(isBelow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    line->setStretch(0, isBelow ? 0 : kLabelStretch);  // the stretches apply to widths
    line->setStretch(1, isBelow ? 0 : kEditorStretch);
    m_box->view()->setMinimumWidth(m_box->view()->sizeHintForColumn(0) + kListMargin);
  }
  m_box->setCurrentIndex(choiceOf(property));
  m_box->setToolTip(m_box->currentText());
}

void ChoiceRow::setLabel(const QString& label) {
  m_box->setAccessibleName(label);
}

ListRow::ListRow(QWidget* parent) : PropertyRow(parent), m_list(new QListWidget(this)) {
  m_list->setObjectName(QStringLiteral("propertyList/choices"));
  m_list->setWordWrap(true);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the view
  arrange(m_list, false);
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0) emit edited(static_cast<double>(row), false);
  });
}

void ListRow::showValue(const Property& property, LengthUnit) {
  const QSignalBlocker quiet(m_list);
  const int count = static_cast<int>(property.choices.size());
  while (m_list->count() > count) delete m_list->takeItem(m_list->count() - 1);
  while (m_list->count() < count) m_list->addItem(QString());
  for (int i = 0; i < count; ++i) m_list->item(i)->setText(translated(property.choices[static_cast<std::size_t>(i)]));
  m_list->setCurrentRow(choiceOf(property));
  constexpr int kPadding = 8;  // pixels of a row
  const int row = 2 * m_list->fontMetrics().lineSpacing() + kPadding;
  m_list->setFixedHeight(std::clamp(count, 1, kMostListed) * row + 2 * m_list->frameWidth());
}

void ListRow::setLabel(const QString& label) {
  m_list->setAccessibleName(label);
}

ReadOnlyRow::ReadOnlyRow(QWidget* parent) : PropertyRow(parent), m_text(new QLabel(this)) {
  m_text->setObjectName(QStringLiteral("propertyValue"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_text->setWordWrap(true);
  m_text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  arrange(m_text);
}

void ReadOnlyRow::showValue(const Property& property, LengthUnit unit) {
  if (std::holds_alternative<std::string>(property.value)) {
    m_text->setText(plainText(property));
  } else if (!property.choices.empty()) {
    const int index = choiceOf(property);
    m_text->setText(index < 0 ? QString() : translated(property.choices[static_cast<std::size_t>(index)]));
  } else if (const bool* on = std::get_if<bool>(&property.value)) {
    m_text->setText(*on ? tr("yes") : tr("no"));
  } else if (const double* number = std::get_if<double>(&property.value); number && isCount(property)) {
    m_text->setText(locale().toString(static_cast<qlonglong>(*number)));
  } else if (number) {
    m_text->setText(QString::fromStdString(property.prefix) + quantityText(*number, property.quantity, unit, locale()));
  }
}

void ReadOnlyRow::setLabel(const QString& label) {
  m_text->setAccessibleName(label);
}

}  // namespace handwheel
