# unit tests of src/result
