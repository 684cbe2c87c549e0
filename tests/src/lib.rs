//! Shared by the tests: the reference systems as one list.
