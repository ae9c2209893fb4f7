// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QtTest>

// Macros that make the test classes of a folder one program. It runs the class that is named; so the program is linked
// once instead of once for each class. A source ends with HANDWHEEL_TEST(Class) or one of the macros that are built on
// HANDWHEEL_TEST_RUN.
namespace handwheel::test {

// Registers a class; run as main() of a program that has no other.
struct TestClass {
  using Run = int (*)(int argc, char** argv);
  TestClass(const char* name, Run run);
};

template <class Application, class Test>
int runTest(int argc, char** argv) {
  Application application(argc, argv);
  QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace handwheel::test

#define HANDWHEEL_TEST_RUN(Test, ...) static const handwheel::test::TestClass registered##Test(#Test, __VA_ARGS__);
#define HANDWHEEL_TEST(Test) HANDWHEEL_TEST_RUN(Test, handwheel::test::runTest<QCoreApplication, Test>)
// Runs with a QApplication; QApplication and the like stay out of the programs of the core.
#define HANDWHEEL_WIDGET_TEST(Test) HANDWHEEL_TEST_RUN(Test, handwheel::test::runTest<QApplication, Test>)
