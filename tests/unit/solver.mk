# unit tests of src/solver
