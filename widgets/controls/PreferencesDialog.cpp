// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/PreferencesDialog.h"

#include "controls/ShortcutEditor.h"
#include "text/Translations.h"
#include "theme/Icons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QSpinBox>
#include <QStackedWidget>

namespace handwheel {

namespace {

QLabel* note(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("muted", true);
  label->setWordWrap(true);
  return label;
}

// Creates a page with one line: a label and a field.
QFormLayout* line(QWidget* page, const QString& label, QWidget* field) {
  auto* form = new QFormLayout(page);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(8);
  form->addRow(label, field);
  form->labelForField(field)->setMinimumHeight(field->sizeHint().height());  // on one line with it
  return form;
}

QComboBox* comboBox(const char* name, const QString& label, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(label);
  return box;
}

}  // namespace

PreferencesDialog::PreferencesDialog(ShortcutModel* keys, std::vector<NavigationChoice> navigation, QWidget* parent)
    : QDialog(parent),
      m_navigation(std::move(navigation)),
      m_preferences(loadPreferences()),
      m_titles(new QListWidget(this)),
      m_pages(new QStackedWidget(this)) {
  setObjectName(QStringLiteral("preferences"));
  setWindowTitle(tr("Preferences"));
  m_titles->setObjectName(QStringLiteral("preferencePages"));
  m_titles->setAccessibleName(tr("Pages"));
  m_titles->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(m_titles, &QListWidget::currentRowChanged, m_pages, &QStackedWidget::setCurrentIndex);
  addPage("keyboard", tr("Keys"), new ShortcutEditor(keys, this));
  addPage("mouse", tr("Mouse"), mousePage());
  addPage("ruler", tr("Units"), unitsPage());
  addPage("language", tr("Language"), languagePage());
  addPage("save", tr("Autosave"), autosavePage());
  addPage("sound", tr("Sound"), soundPage());
  m_titles->setFixedWidth(m_titles->sizeHintForColumn(0) + 24);
  m_titles->setCurrentRow(0);
  auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(close, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  row->addWidget(m_titles);
  row->addWidget(m_pages, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(close);
  resize(640, 480);
}

void PreferencesDialog::addPage(const char* iconName, const QString& title, QWidget* page) {
  auto* item = new QListWidgetItem(icon(QString::fromLatin1(iconName)), title, m_titles);
  item->setSizeHint({item->sizeHint().width(), m_titles->fontMetrics().height() + 12});
  m_pages->addWidget(page);
}

QWidget* PreferencesDialog::mousePage() {
  auto* page = new QWidget(this);
  auto* box = comboBox("navigationChoice", tr("Mouse navigation"), page);
  for (const NavigationChoice& choice : m_navigation) box->addItem(choice.name, choice.id);
  box->setCurrentIndex(std::max(0, box->findData(m_preferences.navigation)));
  auto* description = note({}, page);
  const auto describe = [this, box, description] {
    const int index = box->currentIndex();
    description->setText(index < 0 ? QString() : m_navigation[static_cast<std::size_t>(index)].description);
  };
  describe();
  connect(box, &QComboBox::activated, this, [this, box, describe] {
    m_preferences.navigation = box->currentData().toString();
    describe();
    store();
  });
  QFormLayout* form = line(page, tr("Move the view as in"), box);
  form->addRow(description);
  addSpaceMouse(form);
  return page;
}

void PreferencesDialog::addSpaceMouse(QFormLayout* form) {
  auto* on = new QCheckBox(tr("A space mouse moves the view"), this);
  on->setObjectName(QStringLiteral("spaceMouseOn"));
  on->setChecked(m_preferences.hasSpaceMouse);
  auto* speed = new QSpinBox(this);
  speed->setObjectName(QStringLiteral("spaceMouseSpeed"));
  speed->setAccessibleName(tr("Speed of the space mouse"));
  speed->setRange(kLeastSpaceMouseSpeed, kLargestSpaceMouseSpeed);
  speed->setSingleStep(10);
  speed->setSuffix(tr(" %"));
  speed->setValue(m_preferences.spaceMouseSpeed);
  speed->setEnabled(on->isChecked());
  const auto use = [this, on, speed] {
    speed->setEnabled(on->isChecked());
    m_preferences.hasSpaceMouse = on->isChecked();
    m_preferences.spaceMouseSpeed = speed->value();
    store();
  };
  connect(on, &QCheckBox::toggled, this, use);
  connect(speed, &QSpinBox::valueChanged, this, use);
  form->addRow(on);
  form->addRow(tr("Its speed"), speed);
  form->addRow(note(tr("Its axes are set in the panel “Device” while it is the chosen device."), this));
}

QWidget* PreferencesDialog::unitsPage() {
  auto* page = new QWidget(this);
  auto* box = comboBox("lengthUnitChoice", tr("Length unit"), page);
  box->addItem(tr("Millimetres (mm)"), static_cast<int>(LengthUnit::Millimetre));
  box->addItem(tr("Centimetres (cm)"), static_cast<int>(LengthUnit::Centimetre));
  box->addItem(tr("Metres (m)"), static_cast<int>(LengthUnit::Metre));
  box->addItem(tr("Inches (in)"), static_cast<int>(LengthUnit::Inch));
  box->setCurrentIndex(box->findData(static_cast<int>(m_preferences.lengthUnit)));
  connect(box, &QComboBox::activated, this, [this, box] {
    m_preferences.lengthUnit = static_cast<LengthUnit>(box->currentData().toInt());
    store();
  });
  line(page, tr("Lengths of new documents"), box)
      ->addRow(note(tr("Each document can show another unit. Every field takes all units: “1 in + 2 mm”."), page));
  return page;
}

QWidget* PreferencesDialog::languagePage() {
  auto* page = new QWidget(this);
  auto* box = comboBox("languageChoice", tr("Language"), page);
  box->addItem(tr("As the system"), QStringLiteral("system"));
  for (const Language& language : windowLanguages()) box->addItem(language.name, language.code);
  box->setCurrentIndex(std::max(0, box->findData(m_preferences.language)));
  connect(box, &QComboBox::activated, this, [this, box] {
    m_preferences.language = box->currentData().toString();
    store();
  });
  line(page, tr("Language"), box)->addRow(note(tr("Takes effect at the next start."), page));
  return page;
}

QWidget* PreferencesDialog::autosavePage() {
  auto* page = new QWidget(this);
  auto* on = new QCheckBox(tr("Save a recovery copy while working"), page);
  on->setObjectName(QStringLiteral("autosaveOn"));
  on->setChecked(m_preferences.autosaveSeconds > 0);
  auto* seconds = new QSpinBox(page);
  seconds->setObjectName(QStringLiteral("autosaveSeconds"));
  seconds->setAccessibleName(tr("Seconds between recovery copies"));
  seconds->setRange(kShortestAutosave, kLongestAutosave);
  seconds->setSuffix(tr(" s"));
  seconds->setValue(on->isChecked() ? m_preferences.autosaveSeconds : Preferences().autosaveSeconds);
  seconds->setEnabled(on->isChecked());
  const auto use = [this, on, seconds] {
    seconds->setEnabled(on->isChecked());
    m_preferences.autosaveSeconds = on->isChecked() ? seconds->value() : 0;
    store();
  };
  connect(on, &QCheckBox::toggled, this, use);
  connect(seconds, &QSpinBox::valueChanged, this, use);
  QFormLayout* form = line(page, tr("At the latest after"), seconds);
  form->insertRow(0, on);
  form->addRow(
      note(tr("The copy is kept beside your files, never in their place; after a crash it is offered to you."), page));
  form->addRow(note(tr("It is made within a second after each edit, less often where that takes long."), page));
  return page;
}

QWidget* PreferencesDialog::soundPage() {
  auto* page = new QWidget(this);
  auto* on = new QCheckBox(tr("Play the sound of machines"), page);
  on->setObjectName(QStringLiteral("machineSoundOn"));
  on->setChecked(m_preferences.hasMachineSound);
  auto* volume = new QSpinBox(page);
  volume->setObjectName(QStringLiteral("machineVolume"));
  volume->setAccessibleName(tr("Volume of machines"));
  volume->setRange(kLeastMachineVolume, kLargestMachineVolume);
  volume->setSingleStep(5);
  volume->setSuffix(tr(" %"));
  volume->setValue(m_preferences.machineVolume);
  volume->setEnabled(on->isChecked());
  const auto use = [this, on, volume] {
    volume->setEnabled(on->isChecked());
    m_preferences.hasMachineSound = on->isChecked();
    m_preferences.machineVolume = volume->value();
    store();
  };
  connect(on, &QCheckBox::toggled, this, use);
  connect(volume, &QSpinBox::valueChanged, this, use);
  QFormLayout* form = line(page, tr("Volume"), volume);
  form->insertRow(0, on);
  form->addRow(note(tr("Spindle and cut, from speed, feed, force and wear. Louder means more force; a deep tone "
                       "means chatter."),
                    page));
  return page;
}

void PreferencesDialog::store() {
  storePreferences(m_preferences);
  emit changed(m_preferences);
}

}  // namespace handwheel
