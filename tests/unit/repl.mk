# unit tests of src/repl
