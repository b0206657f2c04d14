//! A table for keys that are the indices of a list.

use std::marker::PhantomData;

/// An index of a list.
pub(crate) trait Index: Copy {
    fn index(self) -> usize;
}

/// A value for each of some indices. A look-up is that of a vector, which an expansion does a million times.
#[derive(Clone, Debug)]
pub(crate) struct IndexTable<Key, Value> {
    values: Vec<Option<Value>>,
    keys: PhantomData<Key>,
}

impl<Key, Value> Default for IndexTable<Key, Value> {
    fn default() -> Self {
        Self {
            values: Vec::new(),
            keys: PhantomData,
        }
    }
}

impl<Key: Index, Value: Copy> IndexTable<Key, Value> {
    pub(crate) fn get(&self, key: Key) -> Option<Value> {
        match self.values.get(key.index()) {
            Some(value) => *value,
            None => None,
        }
    }

    pub(crate) fn insert(&mut self, key: Key, value: Value) {
        let index = key.index();
        if self.values.len() <= index {
            self.values.resize(index + 1, None);
        }
        self.values[index] = Some(value);
    }

    pub(crate) fn clear(&mut self) {
        self.values.clear();
    }
}
