// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercise/SubmissionTable.h"

#include "TestClass.h"

#include <QtTest>

using namespace handwheel;

namespace {

Exercise task() {
  Exercise exercise;
  MarkingCriterion diameter;
  diameter.id = "d";
  diameter.name = "Diameter \"front\", 20";
  diameter.upper = 20.0;
  diameter.points = 8.0;
  MarkingCriterion time = diameter;
  time.id = "t";
  time.name = "Time";
  time.points = 2.0;
  exercise.criteria = {diameter, time};
  return exercise;
}

SubmissionRow row(const char* student, double diameter, double time, double seconds = 90.0) {
  SubmissionRow each;
  each.file = std::string(student) + ".handwheel";
  each.attempt.student = student;
  each.attempt.handedIn = "2026-11-23T08:15:00Z";
  each.attempt.seconds = seconds;
  each.attempt.hints = {1, 2};
  each.marking = markMeasurements(task(), {{"d", diameter, {}}, {"t", time, {}}});
  return each;
}

SubmissionTable fourStudents() {
  SubmissionTable table(task());
  table.add(row("Ada", 20.0, 30.0));
  table.add(row("=Bob", 19.0, 10.0, 600.0));
  table.add(row("Cleo, the 2nd", 30.0, 30.0));
  SubmissionRow unread = row("", 0, 0);
  unread.marking = {};
  unread.problem = "the file is damaged";
  table.add(unread);
  return table;
}

std::string students(const SubmissionTable& table) {
  std::string all;
  for (std::size_t i = 0; i < table.rows().size(); ++i) all += table.cell(i, SubmissionTable::Student) + "|";
  return all;
}

}  // namespace

class SubmissionTableTest : public QObject {
  Q_OBJECT

 private slots:
  void cells() {
    const SubmissionTable table = fourStudents();
    QCOMPARE(table.columns(), std::size_t{SubmissionTable::FirstCriterion} + 2);
    QCOMPARE(table.cell(0, SubmissionTable::Points), std::string("8"));
    QCOMPARE(table.cell(0, SubmissionTable::Percent), std::string("80"));
    QCOMPARE(table.cell(0, SubmissionTable::Minutes), std::string("1.5"));
    QCOMPARE(table.cell(0, SubmissionTable::Hints), std::string("3"));
    QCOMPARE(table.cell(1, SubmissionTable::FirstCriterion + 1), std::string("2"));
    QCOMPARE(table.heading(SubmissionTable::FirstCriterion), task().criteria[0].name);
    QCOMPARE(table.cell(3, SubmissionTable::Points), std::string("the file is damaged"));
    QCOMPARE(table.cell(3, SubmissionTable::Percent), std::string());
  }

  void sortsByValueAndByName() {
    SubmissionTable table = fourStudents();
    table.sort(SubmissionTable::Points, true);
    QCOMPARE(students(table), std::string("=Bob|Ada|Cleo, the 2nd||"));
    table.sort(SubmissionTable::Points, false);
    QCOMPARE(students(table), std::string("Cleo, the 2nd|Ada|=Bob||"));  // unmarked rows stay last
    table.sort(SubmissionTable::Student, false);
    QCOMPARE(students(table), std::string("=Bob|Ada|Cleo, the 2nd||"));
    table.sort(SubmissionTable::Minutes, true);
    QCOMPARE(students(table).substr(0, 5), std::string("=Bob|"));
    table.sort(SubmissionTable::FirstCriterion + 1, true);
    QCOMPARE(students(table).substr(0, 5), std::string("=Bob|"));
  }

  // By hand, by program, both; unknown origins come last.
  void howItWasMade() {
    SubmissionTable table(task());
    const std::pair<const char*, WorkOrigin> works[] = {{"Ada", WorkOrigin::Program},
                                                        {"Bob", WorkOrigin::Unknown},
                                                        {"Cleo", WorkOrigin::Both},
                                                        {"Dora", WorkOrigin::Hand}};
    for (const auto& [student, origin] : works) {
      table.add(row(student, 20.0, 10.0));
      SubmissionRow known = table.rows().back();
      known.origin = origin;
      known.attempt.student += "2";
      table.add(known);
    }
    QCOMPARE(table.cell(0, SubmissionTable::Made), std::string());
    QCOMPARE(table.cell(1, SubmissionTable::Made), std::string("by program"));
    QCOMPARE(table.cell(5, SubmissionTable::Made), std::string("both"));
    QCOMPARE(table.cell(7, SubmissionTable::Made), std::string("by hand"));
    QVERIFY(!table.isNumber(SubmissionTable::Made));
    table.sort(SubmissionTable::Made, false);
    QCOMPARE(students(table), std::string("Cleo2|Dora2|Ada2|Ada|Bob|Bob2|Cleo|Dora|"));
    // Translated to the language of the window.
    const std::string csv = table.csv([](const std::string& word) { return "<" + word + ">"; });
    QVERIFY(csv.find("<Made>") != csv.npos && csv.find("<by hand>") != csv.npos && csv.find("<>") == csv.npos);
    // A command, alone and with others.
    const std::pair<WorkOrigin, const char*> others[] = {{WorkOrigin::Command, "by command"},
                                                         {WorkOrigin::HandAndCommand, "by hand and command"},
                                                         {WorkOrigin::ProgramAndCommand, "by program and command"},
                                                         {WorkOrigin::All, "by hand, program and command"}};
    for (const auto& [origin, text] : others) {
      SubmissionRow made = row("Eve", 20.0, 10.0);
      made.origin = origin;
      table.add(made);
      QCOMPARE(table.cell(table.rows().size() - 1, SubmissionTable::Made), std::string(text));
    }
  }

  // Follows RFC 4180; no field is a formula to a spreadsheet.
  void csv() {
    SubmissionTable table(task());
    SubmissionRow bob = row("=Bob", 19.0, 10.0);
    bob.tries = 2;
    table.add(bob);
    table.add(row("Cleo, \"the 2nd\"", 30.0, 30.0));
    QCOMPARE(
        QByteArray::fromStdString(table.csv()),
        QByteArray(
            "\xEF\xBB\xBFStudent,Points,Percent,Minutes,Hints,Made,Tries,Handed in,File,\"Diameter \"\"front\"\", 20 "
            "(points)\",Time (points)\r\n"
            "'=Bob,10,100,1.5,3,,2,2026-11-23T08:15:00Z,'=Bob.handwheel,8,2\r\n"
            "\"Cleo, \"\"the 2nd\"\"\",0,0,1.5,3,,,2026-11-23T08:15:00Z,\"Cleo, \"\"the 2nd\"\".handwheel\",0,0\r\n"));
    QCOMPARE(SubmissionTable(Exercise()).csv(),
             std::string("\xEF\xBB\xBFStudent,Points,Percent,Minutes,Hints,Made,Tries,Handed in,File\r\n"));
  }
};

HANDWHEEL_TEST(SubmissionTableTest)
#include "SubmissionTableTest.moc"
