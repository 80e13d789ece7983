// ritz-reduce: from a mesh to a reduced model, on any number of ranks.
#include "ritz/app/program.hpp"
#include "ritz/config/advice.hpp"

int main(int argc, char** argv) {
  return ritz::app::run_program(argc, argv, ritz::config::Program::reduce,
                                ritz::config::with_advice(ritz::app::reduce));
}
