# unit tests of src/batch
