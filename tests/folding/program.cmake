# A program of its own, because its calls of stat(2) go through folding.cpp.
nacre_test_program(nacre-test-folding folding nacre_core ${CMAKE_DL_LIBS})
